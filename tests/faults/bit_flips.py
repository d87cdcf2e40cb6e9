#!/usr/bin/env python3
"""Flips single bits in result files and checks how the program reads them.

    bit_flips.py PROGRAM LIBRARY [--flips N] [--every-verb] [--anywhere] [--seed S] [--only WORD] [--at BIT]

PROGRAM: morula; LIBRARY: tests/preload/failing.cpp, which kills a run after a checkpoint. There are three files: the
databases of an unfinished and of a finished run, and the study.db of a study. N bits of each are flipped, one at a time.
Their positions depend only on S and spread over the file without its empty parts (--anywhere: over the whole file); N
more lie in the checkpoint's state. By default the verbs take turns; with --every-verb each verb reads each file. One of
two properties must hold:

  - the flip is detected: the exit code is 6 (of replay also 1), with a sentence on standard error
  - the flip has no effect: exit code, standard output and all that is written are those of the file without a flip; a database
    that a run was resumed in holds the same rows, but for the times at which the run began and ended

No verb ends with 70, by a signal or never.
"""
import argparse
import collections
import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile

SCENE = """morula: 1
name: bodies
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
stop: {time: 1.25}
cycle: {length: 1}
physics: {time_step: 0.0078125, mesh: {icosphere: 1}, drag: 10, contact: {}}
record: {every: 0.25, measures: [extent_1], meshes: 0.5}
connections: {make: at-division, strength: 0.02}
"""
STUDY = """morula-study: 1
name: few
base: bodies.yaml
vary: {drag: {low: {physics.drag: 8}, high: {physics.drag: 12}}}
seeds: 1..3
measures: [neighbours, sphericity]
keep: {samples: end}
check:
  - {measure: sphericity, a: {drag: low}, b: {drag: high}, says: lower}
"""
LIMIT = 1200  # [s] a verb that takes longer counts as endless
DETECTED = {"replay": {1, 6}}
Verb = collections.namedtuple("Verb", "name words writes")
READING = [
    Verb("export csv", ["export", "FILE", "--format", "csv", "-o", "out", "--quiet"], True),
    Verb("lineage", ["lineage", "FILE", "--quiet"], False),
    Verb("chart", ["chart", "FILE", "cell.volume", "-o", "out.svg", "--quiet"], True),
    Verb("report", ["report", "FILE", "--frames", "2", "-o", "out.html", "--quiet"], True),
]
KINDS = {
    "unfinished": [Verb("resume", ["run", "bodies.yaml", "--resume", "--no-pictures", "--db", "FILE", "--quiet"], True), *READING],
    "finished": [*READING, Verb("replay", ["replay", "FILE", "--quiet"], False)],
    "study": [Verb("compare", ["compare", "FILE", "--json", "--quiet"], False),
              Verb("study check", ["study", "check", "FILE", "--quiet"], False),
              Verb("export csv", ["export", "FILE", "--format", "csv", "-o", "out", "--quiet"], True),
              Verb("report", ["report", "FILE", "-o", "out.html", "--quiet"], True)],
}
Result = collections.namedtuple("Result", "code out err files")


class Place:
    """A folder in which the program reads one file at a time, always under the same name."""

    def __init__(self, program, library, folder):
        self.program, self.library, self.work = program, library, os.path.join(folder, "work")
        self.environment = {"PATH": os.environ["PATH"], "HOME": folder, "LANG": "C.UTF-8", "USER": "one",
                            "MESA_SHADER_CACHE_DIR": os.path.join(folder, "shaders"), "GIT_CEILING_DIRECTORIES": folder}

    def clear(self):
        shutil.rmtree(self.work, ignore_errors=True)
        os.mkdir(self.work)
        for name, text in (("bodies.yaml", SCENE), ("few.study.yaml", STUDY)):
            with open(os.path.join(self.work, name), "w") as file:
                file.write(text)

    def start(self, words, **more):
        process = subprocess.Popen([self.program, *words], cwd=self.work, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, start_new_session=True, env={**self.environment, **more})
        try:
            out, err = process.communicate(timeout=LIMIT)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return 124, b"", b"the program did not end"
        return process.returncode, out, err

    def make(self, words, name, code=0, **more):
        """The bytes of a file that a command writes."""
        self.clear()
        if "FAULT_COUNT" in more:
            with open(more["FAULT_COUNT"], "wb") as count:
                count.write(bytes(256))
        ended = self.start(words, **more)
        assert ended[0] in (code, 1), (words, ended)
        file = os.path.join(self.work, name)
        database = sqlite3.connect(file)  # opening rolls back unfinished transactions
        database.execute("SELECT count(*) FROM sqlite_schema").fetchone()
        database.close()
        with open(file, "rb") as data:
            return data.read()

    def read(self, verb, content):
        self.clear()
        file = os.path.join(self.work, "run.db")
        with open(file, "wb") as out:
            out.write(content)
        code, out, err = self.start(["run.db" if word == "FILE" else word for word in verb.words])
        return Result(code, out, err, self.written(content) if verb.writes else {})

    def written(self, content):
        held = {}
        for path, _, names in os.walk(self.work):
            for name in names:
                file = os.path.join(path, name)
                with open(file, "rb") as data:
                    now = data.read()
                name = os.path.relpath(file, self.work)
                if name != "run.db":
                    held[name] = now
                elif now != content:
                    held[name] = rows_of(file)
        return held


def rows_of(file):
    """All rows of a database, without times of their making and without digests of rows that hold such times."""
    database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    database.text_factory = bytes
    held = {}
    try:
        for (table,) in database.execute("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name").fetchall():
            table = table.decode(errors="replace")
            cursor = database.execute(f'SELECT * FROM "{table}"')
            columns = [c[0] for c in cursor.description]
            keep = [i for i, c in enumerate(columns) if c not in ("started", "ended", "made")]
            held[table] = sorted(repr([row[i] for i in keep]) for row in cursor
                                 if not (table == "row_digest" and row[columns.index("name")] in (b"run", b"checkpoint")))
    except (sqlite3.DatabaseError, ValueError) as error:
        held["damaged"] = str(error)
    finally:
        database.close()
    return held


def used_bytes(content):
    """The places of a file's bytes, without long runs of zeros, which are empty parts of SQLite's pages."""
    used, last = [], 0
    for empty in re.finditer(rb"\0{64,}", content):
        used += range(last, empty.start())
        last = empty.end()
    return used + list(range(last, len(content)))


def positions(places, count, seed):
    """Bits to flip: one in each of `count` equal parts of these places, so that they spread over them."""
    draw = random.Random(f"{seed}")
    bits = [int((i + draw.random()) * 8 * len(places) / count) for i in range(count)]
    return [8 * places[bit // 8] + bit % 8 for bit in bits]


def flipped(content, bit):
    changed = bytearray(content)
    changed[bit // 8] ^= 1 << bit % 8
    return bytes(changed)


def state_pages(content):
    """The places of the bytes of those pages that the checkpoint's state fills."""
    with tempfile.NamedTemporaryFile(suffix=".db") as file:
        file.write(content)
        file.flush()
        database = sqlite3.connect(file.name)
        state = database.execute("SELECT state FROM checkpoint").fetchone()[0]
        size = database.execute("PRAGMA page_size").fetchone()[0]
        database.close()
    # A value longer than a page goes on in overflow pages, each of which begins with the number of the next one.
    places = [at for page in range(0, len(content), size) if content[page + 4:page + 68] in state
              for at in range(page, page + size)]
    assert places, "no page holds the checkpoint's state alone"
    return places


def judge(verb, result, good):
    """The fault of this result, or the property that it has."""
    if result.code in DETECTED.get(verb.name, {6}) and result.code != good.code:
        # `replay` reports findings on standard output.
        return "detected" if (result.err or result.out).strip() else f"exit {result.code} without a sentence"
    if result.code < 0 or result.code in (70, 124):
        return f"exit {result.code}: {result.err.decode(errors='replace').strip()[-300:]}"
    if result.code == good.code and result.out == good.out and result.files == good.files:
        return "without effect"
    what = [name for name in result.files.keys() | good.files.keys() if result.files.get(name) != good.files.get(name)]
    return (f"exit {result.code} in place of {good.code}; other: {' '.join(what + ['standard output'] * (result.out != good.out))}"
            f"; {result.err.decode(errors='replace').strip()[-300:]}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--flips", type=int, default=40, help="bits of each file")
    parser.add_argument("--every-verb", action="store_true", help="each verb reads each file; otherwise they take turns")
    parser.add_argument("--anywhere", action="store_true", help="bits of the whole file; otherwise not of its empty parts")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="only files or verbs with this in their name: 'study: compare'")
    parser.add_argument("--at", type=int, help="only this bit")
    options = parser.parse_args()
    counts, defects = collections.Counter(), 0
    with tempfile.TemporaryDirectory(prefix="morula-flips-") as folder:
        folder = os.path.realpath(folder)
        place = Place(os.path.abspath(options.program), os.path.abspath(options.library), folder)
        run = ["run", "bodies.yaml", "--quiet", "--no-pictures", "--db", "run.db"]
        files = {
            "unfinished": place.make(run + ["--checkpoint-every", "20"], "run.db", -signal.SIGKILL, LD_PRELOAD=place.library,
                                     FAULT="sync:24:kill", FAULT_FOLDER=place.work, FAULT_COUNT=os.path.join(folder, "count")),
            "finished": place.make(run, "run.db"),
            "study": place.make(["study", "run", "few.study.yaml", "--quiet", "--no-predict", "--out", "study"],
                                "study/study.db"),
        }
        state = state_pages(files["unfinished"])
        sets = [("checkpoint", "unfinished", positions(state, options.flips, options.seed))]
        for kind, content in files.items():
            places = range(len(content)) if options.anywhere else used_bytes(content)
            if kind == "unfinished" and not options.anywhere:
                places = sorted(set(places) - set(state))
            sets.append((kind, kind, positions(places, options.flips, options.seed)))
        for name, kind, bits in sets:
            content, verbs = files[kind], [v for v in KINDS[kind] if options.only in f"{name}: {v.name}"]
            if name == "checkpoint":
                verbs = [v for v in verbs if v.name == "resume"]
            good = {v.name: place.read(v, content) for v in verbs}
            for verb in verbs:
                again = place.read(verb, content)
                assert good[verb.name].code in (0, 1, 5), (name, verb.name, again)
                assert verb.name != "resume" or b"resumed  at step" in again.out, "the unfinished run was not resumed"
                assert again == good[verb.name], f"{name}: {verb.name} is not the same twice"
            tally = collections.Counter()
            for i, bit in enumerate([options.at] if options.at is not None else bits):
                for verb in verbs if options.every_verb else [verbs[i % len(verbs)]] if verbs else []:
                    found = judge(verb, place.read(verb, flipped(content, bit)), good[verb.name])
                    if found not in ("detected", "without effect"):
                        print(f"  {name}, bit {bit}, {verb.name}: {found}", flush=True)
                        found = "wrong"
                        defects += 1
                    tally[found] += 1
            if verbs:
                print(f"{name} ({len(content)} bytes): {dict(sorted(tally.items()))}", flush=True)
            counts += tally
    print(f"{sum(counts.values())} flips were read: {dict(sorted(counts.items()))}")
    return 1 if defects or not counts else 0


if __name__ == "__main__":
    sys.exit(main())

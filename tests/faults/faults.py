#!/usr/bin/env python3
"""Lets every operation of the program fail, one after the other, and checks the remaining files.

    faults.py PROGRAM LIBRARY [--every K] [--only WORD] [--kind KIND] [--places] [--list]

PROGRAM: morula; LIBRARY: tests/preload/failing.cpp. Each verb below runs in copies of one folder and fails at the n-th
operation, for every n and in each of the ways below. Of the many thousand requests for memory the first 100 fail, then
some at even distances; with --places the first from each place in the program, because requests with the same six
innermost calls are taken to fail alike. After each failure:

  - the exit code is one that is documented; never 70, a signal or a hang; with 0 the result is that of a run without a fault
  - else there is a sentence on standard error
  - each file is the one that was there, or the whole one of a run without a fault; a database is sound
  - nothing else lies there; only after a kill, and until the next run
  - the same command, without a fault, then gives what it gives where nothing ever failed
"""
import argparse
import collections
import ctypes
import os
import re
import shutil
import signal
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time

# The ways in which the n-th operation on a file fails: alone, or with all later ones, as on a full disk.
FILE_WAYS = [("write", "EIO"), ("write", "short"), ("sync", "EIO"), ("rename", "EIO"), ("make", "EIO"), ("remove", "EIO"),
             ("read", "EIO"), ("files", "ENOSPC+"), ("files", "kill"), ("files", "killall")]
MEMORY_WAYS = [("new", "EIO"), ("malloc", "EIO")]
KINDS = ["write", "sync", "rename", "make", "remove", "read", "files", "new", "malloc"]  # in the order of failing.cpp
ADDR_NO_RANDOMIZE = 0x0040000  # <sys/personality.h>
FIRST, EVENLY = 100, 60  # of memory: the first FIRST requests, and EVENLY ones after them

TREE = """morula: 1
name: tree
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(divide|a1)
stop: {cycles: 3}
record: {every: 1}
"""
BODIES = """morula: 1
name: bodies
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
stop: {time: 1.25}
cycle: {length: 1}
physics: {time_step: 0.0078125, mesh: {icosphere: 1}, drag: 10, contact: {}}
record: {every: 0.5, pictures: 0.625}
"""
SETTLED = """morula: 1
name: settled
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
stop: {time: 1.25}
cycle: {length: 1}
physics: {integrator: quasi-static, mesh: {icosphere: 1}, contact: {}}
record: {every: 0.5, pictures: 1}
"""
STUDY = """morula-study: 1
name: few
base: bodies.yaml
vary: {drag: {low: {physics.drag: 8}, high: {physics.drag: 12}}}
seeds: 1..2
measures: [neighbours, sphericity]
keep: {pictures: first-seed, samples: end}
"""

RUN = ["run", "--quiet"]
Verb = collections.namedtuple("Verb", "name before command")
STORED = [RUN + ["scenarios/bodies.yaml", "--no-pictures"]]
DATABASE = "results/bodies-0/run.db"


def exported(name, *words):
    return Verb(f"export {name}", STORED, ["export", "--quiet", DATABASE, *words])


# `before`: commands that prepare the verb; a first word "FAULT=…" sets their fault.
VERBS = [
    Verb("run tree", [], RUN + ["scenarios/tree.yaml"]),
    Verb("run bodies", [], RUN + ["scenarios/bodies.yaml", "--no-pictures"]),
    Verb("run settled", [], RUN + ["scenarios/settled.yaml", "--no-pictures"]),
    Verb("run into a database", [RUN + ["scenarios/tree.yaml", "--db", "all.db"]],
         RUN + ["scenarios/bodies.yaml", "--db", "all.db", "--no-pictures", "--checkpoint-every", "40"]),
    Verb("resume", [["FAULT=sync:16:kill"] + RUN + ["scenarios/bodies.yaml", "--checkpoint-every", "20", "--no-pictures"]],
         RUN + ["scenarios/bodies.yaml", "--checkpoint-every", "20", "--no-pictures", "--resume"]),
    Verb("study run", [], ["study", "run", "scenarios/few.study.yaml", "--quiet", "--no-predict"]),
    Verb("study merge", [["study", "run", "scenarios/few.study.yaml", "--quiet", "--no-predict", "--shard", f"{i}/2", "--out",
                          f"shard{i}"] for i in (1, 2)],
         ["study", "merge", "shard1", "shard2", "--quiet"]),
    Verb("review", [], ["review", "--quiet", "scenarios/bodies.yaml", "--accept", "--why", "it is new", "--by", "one"]),
    Verb("review again", [["review", "--quiet", "scenarios/tree.yaml", "--accept", "--why", "first", "--by", "one"],
                          ["SET=scenarios/tree.yaml:cycles: 3:cycles: 4"], ["check", "--quiet", "scenarios/tree.yaml"]],
         ["review", "--quiet", "scenarios/tree.yaml", "--accept", "--why", "longer", "--by", "one"]),
    Verb("check", [["review", "--quiet", "scenarios/tree.yaml", "--accept", "--why", "first", "--by", "one"],
                   ["SET=scenarios/tree.yaml:cycles: 3:cycles: 4"]],
         ["check", "--quiet", "scenarios/tree.yaml", "--reports", "reports"]),
    Verb("report", STORED, ["report", "--quiet", DATABASE, "--frames", "3", "-o", "page.html"]),
    exported("csv", "--format", "csv", "-o", "out"),
    exported("table", "--format", "csv", "--table", "cells", "-o", "out.csv"),
    exported("newick", "--format", "newick", "-o", "out.nwk"),
    exported("vtk", "--format", "vtk", "-o", "out"),
    exported("ply", "--format", "ply", "-o", "out"),
    exported("gltf", "--format", "gltf", "-o", "out"),
    exported("npz", "--format", "npz", "-o", "out.npz"),
    exported("crate", "--ro-crate", "out"),
    Verb("replay", STORED, ["replay", "--quiet", DATABASE, "--db-out", "again.db"]),
    Verb("film", STORED, ["render", "--quiet", DATABASE, "--turntable", "2", "--size", "64", "-o", "film.gif"]),
    Verb("render", STORED, ["render", "--quiet", DATABASE, "--turntable", "2", "--size", "64", "-o", "turn.png"]),
    Verb("chart", STORED, ["chart", "--quiet", DATABASE, "cell.volume", "-o", "chart.pdf"]),
    Verb("lineage", STORED, ["lineage", "--quiet", DATABASE, "-o", "tree.svg"]),
]

STARTING = ("study run", "film")  # verbs that start other processes
Ended = collections.namedtuple("Ended", "code err counts")


class Place:
    """A folder in which the program runs repeatedly, each time from the same files."""

    def __init__(self, program, library, folder):
        self.program, self.library, self.folder = program, library, folder
        self.home, self.count, self.work, self.start = (os.path.join(folder, n) for n in ("home", "count", "work", "start"))
        os.mkdir(self.home)
        self.environment = {"PATH": os.environ["PATH"], "HOME": self.home, "LANG": "C.UTF-8", "USER": "one",
                            "TMPDIR": self.work, "FAULT_FOLDER": self.work, "FAULT_COUNT": self.count,
                            "MESA_SHADER_CACHE_DISABLE": "false", "MESA_SHADER_CACHE_DIR": os.path.join(folder, "shaders"),
                            "GIT_CEILING_DIRECTORIES": folder}

    def run(self, words, fault=None, before=None, fast=0):
        """Runs the program. Returns how it ended (124: it did not), and the number of operations of the fault's kind, or
        of each kind (KINDS). `before`: called in its process; `fast`: seconds by which its clock is fast."""
        with open(self.count, "wb") as file:
            file.write(bytes(8 * (2 + len(KINDS))))
        environment = {**self.environment, "FAULT_CLOCK": str(fast)}
        if fault or fast:
            environment["LD_PRELOAD"] = self.library
        if fault:
            environment["FAULT"] = fault
        process = subprocess.Popen([self.program, *words], cwd=self.work, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True, preexec_fn=before)
        try:
            err = process.communicate(timeout=1200)[1].decode(errors="replace")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return Ended(124, "it did not end", ())
        with open(self.count, "rb") as file:
            counts = [count for (count,) in struct.iter_unpack("<Q", file.read())]
        return Ended(process.returncode if process.returncode >= 0 else 128 - process.returncode, err, counts)

    def counts(self, words):
        """The number of operations of each kind, the same for each way to fail."""
        counts = dict(zip(KINDS, self.run(words, "all:0:EIO").counts[1:]))
        counts["files"] = sum(counts[kind] for kind in KINDS[:KINDS.index("read")])
        return counts

    def places(self, words, kind):
        """The origins of requests for memory, as numbers that are equal in all processes without shuffled addresses."""
        file = os.path.join(self.folder, "places")
        if os.path.exists(file):
            os.remove(file)
        self.environment["FAULT_PLACES"] = file
        try:
            self.run(words, f"{kind}:0:EIO", before=lambda: ctypes.CDLL(None).personality(ADDR_NO_RANDOMIZE))
        finally:
            del self.environment["FAULT_PLACES"]
        with open(file, "rb") as data:
            return [place for (place,) in struct.iter_unpack("<Q", data.read())]

    def prepare(self, verb):
        """Prepares the folder for the verb, and keeps it as `start`."""
        for folder in (self.work, self.start):
            shutil.rmtree(folder, ignore_errors=True)
        for name, text in (("scenarios/tree.yaml", TREE), ("scenarios/bodies.yaml", BODIES),
                           ("scenarios/settled.yaml", SETTLED), ("scenarios/few.study.yaml", STUDY), ("golden/.keep", "")):
            file = os.path.join(self.work, name)
            os.makedirs(os.path.dirname(file), exist_ok=True)
            with open(file, "w") as out:
                out.write(text)
        for words in verb.before:
            if words[0].startswith("SET="):
                name, what, by = re.fullmatch("SET=([^:]*):(.*):(cycles: 4)", words[0]).groups()
                file = os.path.join(self.work, name)
                with open(file) as before:
                    text = before.read()
                with open(file, "w") as out:
                    out.write(text.replace(what, by))
            elif words[0].startswith("FAULT="):
                ended = self.run(words[1:], words[0][len("FAULT="):])
                assert ended.code == 128 + signal.SIGKILL, ended
            else:
                ended = self.run(words)
                assert ended.code in (0, 1), (words, ended)
        shutil.copytree(self.work, self.start)

    def restore(self):
        shutil.rmtree(self.work)
        shutil.copytree(self.start, self.work)


def rows_of(file):
    """The contents of a database, by table and column, or its damage."""
    with tempfile.TemporaryDirectory() as folder:  # a copy, because opening rolls back unfinished transactions
        copy = os.path.join(folder, "copy")
        for ending in ("", "-journal"):
            if os.path.exists(file + ending):
                shutil.copy(file + ending, copy + ending)
        database = sqlite3.connect(copy)
        try:
            sound = database.execute("PRAGMA integrity_check").fetchone()[0]
            held = {}
            for (table,) in database.execute("SELECT name FROM sqlite_schema WHERE type = 'table'").fetchall():
                cursor = database.execute(f'SELECT * FROM "{table}"')
                columns, rows = [c[0] for c in cursor.description], cursor.fetchall()
                for place, column in enumerate(columns):
                    held[table, column] = sorted((repr(row[place]) for row in rows))
            return held if sound == "ok" else {"damaged": sound}
        except sqlite3.DatabaseError as error:
            return {"damaged": str(error)}
        finally:
            database.close()


def held_in(folder):
    """The contents of the folder's files: dictionaries of databases, and bytes of others."""
    held = {}
    for path, _, names in os.walk(folder):
        for name in names:
            file = os.path.join(path, name)
            with open(file, "rb") as data:
                content = data.read()
            if content.startswith(b"SQLite format 3\0"):
                content = rows_of(file)
            held[os.path.relpath(file, folder)] = content
        if not names and path != folder and not os.listdir(path):
            held[os.path.relpath(path, folder) + "/"] = b""
    return held


def plain(content):
    """The text without times and what depends on them."""
    content = re.sub(rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d(\.\d+)?)?Z?", b"TIME", content)
    return re.sub(rb"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", b"N", content)


class Judge:
    def __init__(self, verb, before, good, other):
        self.verb, self.before, self.good = verb, before, good
        # Values that differ between two runs without a fault, mostly times, are not compared. Memory may agree by
        # chance.
        self.loose = {(name, key) for name, held in good.items() if isinstance(held, dict)
                      for key in held if other[name].get(key) != held[key] or key == ("timing", "max_memory")}
        self.varying = {name for name, held in good.items() if isinstance(held, bytes) and other[name] != held}
        for name in self.varying:
            assert self.same(name, other[name], good[name]), f"{verb.name}: {name} differs in more than its times"

    def same(self, name, one, another):
        if isinstance(one, dict) and isinstance(another, dict):
            return one.keys() == another.keys() and all(
                one[key] == another[key] or (name, key) in self.loose for key in one)
        if isinstance(one, bytes) and isinstance(another, bytes) and name in self.varying:
            return plain(one) == plain(another)
        return one == another

    def wrong_files(self, now, after_kill):
        for name, content in now.items():
            if after_kill and re.fullmatch(r"\.morula-.*\.part", os.path.basename(name)):
                continue
            if isinstance(content, dict) and "damaged" in content:
                yield f"{name} is damaged: {content['damaged']}"
            elif name in self.before and self.same(name, content, self.before[name]):
                continue
            elif name in self.good and self.same(name, content, self.good[name]):
                continue
            elif name.endswith("/") and any(other.startswith(name) for other in self.good):
                continue  # an empty folder, to be filled
            elif content == b"" and isinstance(self.good.get(name), dict):
                continue  # a database in which nothing was ever stored
            elif isinstance(content, dict) and name in {**self.good, **self.before}:
                # The database may be incomplete, but must not say that the run is done.
                if "done" in " ".join(content.get(("run", "status"), [])) and not (
                        self.before.get(name) and set(content["run", "run_id"]) >= set(self.before[name]["run", "run_id"])):
                    yield f"{name} says that a run is done, and does not hold what it holds"
            elif not after_kill or name in self.good:
                yield f"{name} " + ("is not whole" if name in self.good else "is left")
        for name in self.before:
            if name not in now and name in self.good and not name.endswith("/"):
                yield f"{name} is gone"


def missing_or_other(judge, now, loose=frozenset()):
    for name in sorted(judge.good.keys() | now.keys()):
        if name not in now or name not in judge.good:
            yield f"after a run without a fault {name} is " + ("left" if name in now else "missing")
        elif not judge.same(name, now[name], judge.good[name]):
            one, another = (x if isinstance(x, dict) else {} for x in (now[name], judge.good[name]))
            places = [".".join(key) for key in one
                      if one[key] != another.get(key) and (name, key) not in judge.loose and key not in loose]
            if places or not isinstance(now[name], dict):
                yield f"after a run without a fault {name} is another one: {' '.join(places)}"


def judged(place, judge, good_code, kind, how, n):
    """The errors after this fault."""
    place.restore()
    ended = place.run(judge.verb.command, f"{kind}:{n}:{how}")
    killed = how.startswith("kill")
    now = held_in(place.work)
    wrong = []
    # A run of a study that lacks memory fails; the study records the failure and ends with 1.
    of_a_run = kind in ("new", "malloc") and judge.verb.name == "study run"
    allowed = {good_code, 6} | ({1} if of_a_run else set()) | ({128 + signal.SIGKILL, 5} if killed else set()) | ({4} if kind in ("new", "malloc") else set())
    if ended.code not in allowed:
        wrong.append(f"exit {ended.code}: {ended.err.strip()[-200:]}")
    if ended.code not in (good_code, 5, 128 + signal.SIGKILL) and "morula" not in ended.err:
        wrong.append(f"exit {ended.code} without a sentence")
    # Files that cannot be removed stay, and a database that cannot be written may need its journal.
    stays = killed or kind == "remove" or how.endswith("+")
    wrong += (text for text in judge.wrong_files(now, stays) if not (of_a_run and "says that" in text))
    if now == judge.before and ended.code != good_code:
        pass  # the next run begins as one without a fault does
    elif ended.code != good_code or killed or of_a_run:
        again = place.run(judge.verb.command + (["--retry-failed"] if of_a_run else []))
        # If memory runs out after the last file took its place, the command fails, and the next run does not replace
        # the whole result.
        was_whole = not list(missing_or_other(judge, now)) and "is there already" in again.err
        if again.code != good_code and not was_whole:
            wrong.append(f"the next run ends with {again.code}: {again.err.strip()[-200:]}")
        # The next run had other arguments, or restarted a resumed run that was done.
        other = {("run", "command"), ("timing", "command")} if of_a_run else {("run", "started")}
        wrong += missing_or_other(judge, held_in(place.work), other)
    elif not stays:
        # A result that waits for a review is optional: `check` says that it is not kept, and judges nevertheless.
        told = "is not kept for a review" in ended.err
        wrong += (text.replace("after a run without a fault", "exit 0, but") for text in missing_or_other(judge, now)
                  if not (told and ".pending" in text))
    return wrong, ended


def numbers(count, kind, every):
    if kind in ("new", "malloc"):
        first, evenly = (FIRST // every, EVENLY // every)
        step = max(1, (count - first) // max(1, evenly))
        return [*range(1, min(first, count) + 1), *range(first + step, count + 1, step)]
    return range(1 + (count // 2) % every, count + 1, every)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("library")
    parser.add_argument("--every", type=int, default=1, help="only every so manieth of them, and few of memory")
    parser.add_argument("--only", default="", help="verbs with this in their name")
    parser.add_argument("--kind", default="", help="only this kind, or only this way: kill")
    parser.add_argument("--at", type=int, help="only this one")
    parser.add_argument("--places", action="store_true", help="of memory: the first from each place that none before came from")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    if options.list:
        return print(*(verb.name for verb in VERBS), sep="\n")
    injected, kills, defects = 0, 0, 0
    known = set()
    with tempfile.TemporaryDirectory(prefix="morula-faults-") as folder:
        place = Place(os.path.abspath(options.program), os.path.abspath(options.library), os.path.realpath(folder))
        for verb in VERBS:
            if options.only not in verb.name:
                continue
            if verb.name == "film" and not shutil.which("ffmpeg"):
                print("film: left out, there is no ffmpeg")
                continue
            place.prepare(verb)
            good = []
            for fast in (0, 2):  # times have a resolution of seconds, and must differ
                place.restore()
                begun = time.monotonic()
                ended = place.run(verb.command, fast=fast)
                seconds = time.monotonic() - begun
                assert ended.code in (0, 1), (verb.name, ended)
                good.append(held_in(place.work))
            judge = Judge(verb, held_in(place.start), *good)
            place.restore()
            line, counts = [], place.counts(verb.command)
            for kind, how in FILE_WAYS + MEMORY_WAYS:
                if options.kind not in (kind, how, "") or (how == "killall" and verb.name not in STARTING):
                    continue
                count, tried = counts[kind], 0
                if options.places and not options.at and kind in ("new", "malloc"):
                    place.restore()
                    came_from = [(kind, where) for where in place.places(verb.command, kind)]
                    at = [n for n, where in enumerate(came_from, 1) if where not in known and not known.add(where)]
                    at = at[(len(at) // 2) % options.every::options.every]
                else:
                    at = [options.at] if options.at else numbers(count, kind, options.every)
                for n in at:
                    wrong, fault = judged(place, judge, ended.code, kind, how, n)
                    tried += 1
                    kills += how.startswith("kill")
                    for text in wrong:
                        print(f"  {verb.name}, {kind}:{n}:{how}: {text}", flush=True)
                    defects += bool(wrong)
                    if options.at:
                        print(fault)
                injected += tried
                line.append(f"{kind}:{how} {tried}" + (f" of {count}" if tried < count else ""))
            print(f"{verb.name} ({seconds:.2f} s): {', '.join(line)}", flush=True)
    print(f"{injected} faults, {kills} of them kills; {defects} with something wrong")
    return 1 if defects or not injected else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Wrong command lines and wrong files, over all verbs: each is refused with the words and the exit code of its table.

    bad_commands.py MORULA [--accept] [TABLE...]

A table (*.txt beside this script) is a list of commands as a shell takes them. Beneath each, or beneath the last of several
that are answered alike, stand its exit code and what it says on standard error, and after > what it says on standard
output; what differs from run to run is left out (ID, HASH, PENDING, SETS, SIZE, CPU), and so is what goes beyond twelve
lines. Lines that begin with ! make files that the commands after them are given; `(a|b)` means a command each, \\1 beneath
it which of them. What is refused leaves every file as it was and makes none, unless standard output says what was done all
the same, and sends a terminal nothing that it would obey. --accept writes what is said now into the tables, to be read
before it is kept, and leaves out what is not refused; without it, either is a fault. A mistake is a command here, or a line
of a message in bad_scenarios, bad_dna and bad_studies: the last line counts both.

Exit codes: 0 passed, 1 failed.
"""
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
program, *words = sys.argv[1:]
accept = "--accept" in words
named = [word for word in words if word != "--accept"]
# Bytes that a terminal obeys, and characters that change the direction of text.
obeyed = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")

# The program `sql FILE TEXT` changes a database from outside.
sql = """#!/usr/bin/env python3
import sqlite3, sys
with sqlite3.connect(sys.argv[1]) as database:
    database.execute("PRAGMA writable_schema = ON")
    database.executescript(sys.argv[2])
"""


def files(folder):
    """The files with the properties that a refused command must not change."""
    found = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        status = path.lstat()
        found[str(path)] = (status.st_mode, status.st_ino, status.st_mtime_ns if path.is_file() else 0)
    return found


def commands(line):
    """Commands for all choices of alternatives, each with the first choice."""
    parts = re.split(r"\(([^()\s]*\|[^()\s]*)\)", line)
    choices = [part.split("|") if i % 2 else [part] for i, part in enumerate(parts)]
    return [("".join(words), "".join(words[1:2])) for words in itertools.product(*choices)]


def shell(command, folder):
    # The limit on CPU time ends endless reads, however slow the machine is. The timeout is a last resort.
    return subprocess.run(["bash", "-c", "ulimit -t 60; " + command], cwd=folder, stdin=subprocess.DEVNULL, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=7200,
                          env={"PATH": f"{folder}/../bin:/usr/local/bin:/usr/bin:/bin", "HOME": folder, "LC_ALL": "C"})


# Text that differs between builds, machines or days.
VARIES = ((r"\b[0-9a-f]{16}\b", "ID"), (r"\S*\.pending/\S+", "PENDING"), (r"\d+\.\d+ MB", "SIZE MB"),
          (r"\d+:\d\d of CPU time", "CPU of CPU time"),
          (r"available: scalar(, \w+)+", "available: SETS"),
          (r"hash is \w+, and \w+ was", "hash is HASH, and HASH was"))
MOST = 12  # lines


def said(run):
    lines = (run.stderr.decode(errors="replace") + "".join("> " + line for line in
             run.stdout.decode(errors="replace").splitlines(keepends=True))).rstrip("\n").split("\n")
    if len(lines) > MOST:
        lines = lines[:MOST - 1] + [f"and {len(lines) - MOST + 1} more lines"]
    text = "\n".join(line.rstrip() for line in lines)
    for pattern, word in VARIES:
        text = re.sub(pattern, word, text)
    return f"{run.returncode} {text}".rstrip()


def try_one(command, folder):
    """The output of the command, and the faults that no table may accept."""
    before = files(folder)
    run = shell("morula " + command, folder)
    faults = []
    if run.returncode not in (1, 2, 3, 4, 5, 6):
        faults.append(f"exit {run.returncode}")
    if obeyed.search((run.stderr + run.stdout).decode(errors="replace")):
        faults.append("sends the terminal what it obeys")
    changed = sorted({path for path, _ in set(before.items()) ^ set(files(folder).items())})
    if changed and not run.stdout:
        faults.append(f"changed {changed}")
    return said(run), faults


def as_written(line, tried):
    """The line with its answer, or a line for each alternative if the answers differ."""
    # Answers count as equal if they are equal literally ("(?!)" matches nothing), but for the verb's name, or but for
    # the word at any place.
    for before in ("(?!)", r"(?:morula:?(?: study)? |study )", r"(?<!\w)"):
        texts = {re.sub(rf"({before}){re.escape(chosen)}(?!\w)", r"\1\\1", text) for _, chosen, text in tried}
        if len(texts) == 1:
            return [(line, texts.pop())]
    return [("$ " + command, text) for command, _, text in tried]


def judge(table, work):
    """The table with present answers, its number of commands, and its faults."""
    os.makedirs(f"{work}/bin")
    os.makedirs(f"{work}/w")
    os.symlink(os.path.abspath(program), f"{work}/bin/morula")
    pathlib.Path(f"{work}/bin/sql").write_text(sql)
    os.chmod(f"{work}/bin/sql", 0o755)
    folder, now, count, faults = f"{work}/w", [], 0, []
    blocks = re.split(r"^(?=[$!#\n])", table.read_text(), flags=re.MULTILINE)
    asked = []  # commands that share the answer beneath the last of them
    for number, block in enumerate(blocks):
        first, _, expected = block.rstrip("\n").partition("\n")
        if first.startswith("! "):
            made = shell(first[2:], folder)
            if made.returncode:
                faults.append(f"{table.name}: {first}\n{made.stderr.decode()}")
        if not first.startswith("$ "):
            now.append((block, None))
            continue
        asked.append(first)
        if not expected and number + 1 < len(blocks) and blocks[number + 1].startswith("$ "):
            continue
        for line in asked:
            tried = []
            for command, chosen in commands(line[2:]):
                count += 1
                text, wrong = try_one(command, folder)
                faults += [f"{table.name}: morula {command}\n{each}" for each in wrong]
                if not accept and text != expected.replace("\\1", chosen):
                    faults.append(f"{table.name}: morula {command}\nsays\n{text}\nnot\n{expected}")
                if not text.startswith("0"):
                    tried.append((command, chosen, text))
            now += as_written(line, tried) if tried else []
        asked = []
    # Neighbours with equal answers share the answer.
    text = "".join(line + "\n" + ("" if i + 1 < len(now) and now[i + 1][1] == answer else answer + "\n")
                   if answer is not None else line for i, (line, answer) in enumerate(now))
    return text, count, faults


total, faults = 0, []
for table in sorted(here.glob("*.txt")):
    if named and table.stem not in named:
        continue
    with tempfile.TemporaryDirectory() as work:
        text, count, wrong = judge(table, work)
    print(f"{table.stem}: {count}")
    total += count
    faults += wrong
    if accept:
        table.write_text(text)
in_files = sum(len(file.read_text().splitlines()) for kind in ("scenarios", "dna", "studies")
               for file in (here.parent / f"bad_{kind}").glob("*.expected"))
print("\n\n".join(faults + [f"{total} wrong command lines, {len(faults)} faults; {in_files} mistakes in files beside"]))
sys.exit(1 if faults else 0)

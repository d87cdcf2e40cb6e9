#!/usr/bin/env python3
"""Wrong command lines and wrong files, over all verbs: each is refused with the words and the exit code of its table.

    bad_commands.py MORULA [--accept] [TABLE...]

A table (*.txt beside this script) is a list of commands as a shell takes them. Beneath each stand its exit code and what
it says on standard error; on standard output it says nothing, or the lines after >. Lines that begin with ! make files
that the commands after them are given; `(a|b)` means a command each, \\1 beneath it which of them. Whatever is refused
leaves every file as it was, makes none, and sends a terminal nothing that it would obey. --accept writes what is said
now into the tables, to be read before it is kept; without it, that is a difference. A mistake is a command here, or a
line of a message in bad_scenarios, bad_dna and bad_studies: the last line counts both.

Exit codes: 0 so it is, 1 not so.
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
# What a terminal obeys, and what turns the direction of its text.
obeyed = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")

# `sql FILE TEXT`: changes a database as somebody else may.
sql = """#!/usr/bin/env python3
import sqlite3, sys
with sqlite3.connect(sys.argv[1]) as database:
    database.execute("PRAGMA writable_schema = ON")
    database.executescript(sys.argv[2])
"""


def files(folder):
    """All files and what of them a refused command must not change."""
    found = {}
    for path in sorted(pathlib.Path(folder).rglob("*")):
        status = path.lstat()
        found[str(path)] = (status.st_mode, status.st_ino, status.st_mtime_ns if path.is_file() else 0)
    return found


def commands(line):
    """A command for each choice of alternatives, and what was chosen first."""
    parts = re.split(r"\(([^()\s]*\|[^()\s]*)\)", line)
    choices = [part.split("|") if i % 2 else [part] for i, part in enumerate(parts)]
    return [("".join(words), "".join(words[1:2])) for words in itertools.product(*choices)]


def shell(command, folder):
    # The limit is of CPU time: what reads for ever is ended, on a machine however slow. The other is a last resort.
    return subprocess.run(["bash", "-c", "ulimit -t 60; " + command], cwd=folder, stdin=subprocess.DEVNULL, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=900,
                          env={"PATH": f"{folder}/../bin:/usr/local/bin:/usr/bin:/bin", "HOME": folder, "LC_ALL": "C"})


def said(run):
    text = (run.stderr.decode(errors="replace") + "".join("> " + line for line in
            run.stdout.decode(errors="replace").splitlines(keepends=True))).rstrip("\n").split("\n")
    return [f"{run.returncode} {text[0]}".rstrip()] + text[1:]


def judge(table, work):
    """The table as it is now, how many commands it holds, and its faults."""
    os.makedirs(f"{work}/bin")
    os.makedirs(f"{work}/w")
    os.symlink(os.path.abspath(program), f"{work}/bin/morula")
    pathlib.Path(f"{work}/bin/sql").write_text(sql)
    os.chmod(f"{work}/bin/sql", 0o755)
    folder, now, count, faults = f"{work}/w", [], 0, []
    blocks = re.split(r"^(?=[$!#\n])", table.read_text(), flags=re.MULTILINE)
    asked = []  # commands that share what stands beneath the last of them
    for number, block in enumerate(blocks):
        first, *expected = block.rstrip("\n").split("\n")
        if first.startswith("! "):
            made = shell(first[2:], folder)
            if made.returncode:
                faults.append(f"{table.name}: {first}\n{made.stderr.decode()}")
        if not first.startswith("$ "):
            now.append(block)
            continue
        asked.append(first)
        if not expected and number + 1 < len(blocks) and blocks[number + 1].startswith("$ "):
            continue
        told = {}  # what is said, and by which of the lines
        for line, (command, chosen) in [(line, each) for line in asked for each in commands(line[2:])]:
            count += 1
            before = files(folder)
            run = shell("morula " + command, folder)
            found = said(run)
            if chosen:
                found = [re.sub(rf"(morula:?( study)? |study ){re.escape(chosen)}\b", r"\1\\1", text) for text in found]
            what = f"{table.name}: morula {command}\n"
            told.setdefault("\n".join(found), []).append((line, command, chosen))
            if not accept and found != expected:
                faults.append(what + "\n".join(["says"] + found + ["not"] + expected))
            if run.returncode not in (1, 2, 3, 4, 5, 6):
                faults.append(what + f"exit {run.returncode}")
            if obeyed.search((run.stderr + run.stdout).decode(errors="replace")):
                faults.append(what + "sends the terminal what it obeys")
            changed = sorted(set(before.items()) ^ set(files(folder).items()))
            if changed:
                faults.append(what + f"changed {sorted({path for path, _ in changed})}")
        for text, said_by in told.items():
            lines = [line for line, _, _ in said_by] if len(told) == 1 else ["$ " + command for _, command, _ in said_by]
            now.append("\n".join([*dict.fromkeys(lines), text.replace("\\1", said_by[0][2]) if len(told) > 1 else text, ""]))
        asked = []
    return "".join(now), count, faults


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

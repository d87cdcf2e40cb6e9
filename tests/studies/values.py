#!/usr/bin/env python3
"""The values of all runs of a study, as golden/FAMILY/NAME.csv keeps them.

   values.py results/studies/NAME/study.db >golden/FAMILY/NAME.csv

A line for each run and time, in the plan's order: the task's id, the hash of its final state, the time, and the measures;
nothing stands for what was not there to be measured. Of a run that failed: its id, `failed` and the reason.
"""
import csv
import sqlite3
import sys


def main(file):
    db = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    measures = [row[0] for row in db.execute("SELECT DISTINCT measure FROM result ORDER BY measure")]
    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["task", "state_hash", "time", *measures])
    tasks = db.execute(
        "SELECT task_id, task.status, reason, run_id, state_hash FROM task LEFT JOIN run USING (run_id) ORDER BY number"
    ).fetchall()
    for task, status, reason, run, state in tasks:
        if status == "missing":
            sys.exit(f"{file}: the run {task} is missing; go on with morula study run")
        if status == "failed":
            print(f"{task},failed,{reason}")  # the unquoted reason is the rest of the line
            continue
        times = {}
        for time, measure, value in db.execute(
            "SELECT time, measure, value FROM result WHERE run_id = ? ORDER BY time", (run,)
        ):
            times.setdefault(time, {})[measure] = repr(value)
        for time, values in times.items():
            out.writerow([task, state, repr(time), *(values.get(m, "") for m in measures)])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])

#!/bin/sh
# morula-run, which has the verb run alone, does what the whole program does: the same help, the same bits, and Bullet asked
# in a process of its own.
#
#   run_program_test.sh MORULA-RUN MORULA       in the folder of the sources
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" run --help >"$scratch/alone"
"$2" run --help | diff "$scratch/alone" -
"$1" run scenarios/bullet/at-rest.yaml --out "$scratch" --no-pictures # exit 1 where a check differs
# Without sqlite3, what was stored of Bullet is still checked by tests/cli/bullet_test.cpp, of the whole program.
if command -v sqlite3 >/dev/null; then
  stored=$(sqlite3 "$scratch"/*/run.db "SELECT count(*) FROM check_result WHERE kind = 'bullet' AND passed")
  [ "$stored" -gt 0 ] || { echo "FAILED: no check against Bullet passed" && exit 1; }
fi
"$2" replay "$scratch"/*/run.db

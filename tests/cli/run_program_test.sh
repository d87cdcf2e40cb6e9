#!/bin/sh
# morula-run, which has only the verb run, does the same as the whole program: equal help, equal bits, and Bullet in a
# separate process.
#
#   run_program_test.sh MORULA-RUN MORULA       in the folder of the sources
set -eu
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$1" run --help >"$scratch/alone"
"$2" run --help | diff "$scratch/alone" -
"$1" run scenarios/bullet/at-rest.yaml --out "$scratch" --no-pictures # exit 1 if a check differs
# Without sqlite3, tests/cli/bullet_test.cpp still checks Bullet's stored results, made by the whole program.
if command -v sqlite3 >/dev/null; then
  stored=$(sqlite3 "$scratch"/*/run.db "SELECT count(*) FROM check_result WHERE kind = 'bullet' AND passed")
  [ "$stored" -gt 0 ] || { echo "FAILED: no check against Bullet passed" && exit 1; }
fi
"$2" replay "$scratch"/*/run.db

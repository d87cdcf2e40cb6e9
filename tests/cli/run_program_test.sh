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
"$1" run scenarios/bullet/at-rest.yaml --out "$scratch" --no-pictures | tee "$scratch/said" # exit 1 where a check differs
grep -q "bullet" "$scratch/said"
"$2" replay "$scratch"/*/run.db

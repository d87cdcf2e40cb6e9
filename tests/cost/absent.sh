#!/usr/bin/env bash
# Checks that runs do not call functions for unrequested features: a plain run calls none of these functions, and a run
# that requests everything calls each. The state is hashed once, at the end, however long the run.
#
#   absent.sh MORULA
#
# Exit codes: 0 passed, 1 failed, 77 skipped: no valgrind, or a compiler that leaves no function to see.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$1
functions='takeSnapshot addPairForces buildNeighbourList refreshList addConnectionForces (morula::ShellShape)3
  findTensions<true addPressureForces<true> measureContactAreas morula::grow(
  findPairStrengths addMotility'

skip() {
  echo "skipped: $*"
  exit 77
}
command -v valgrind >/dev/null || skip "valgrind is not installed"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
valgrind --tool=none "$program" schema >"$work/log" 2>&1 || skip "the program does not run under valgrind here"

# Prints the names of all functions that a run calls, and how often it hashes the state.
calls() {
  valgrind --tool=callgrind --callgrind-out-file="$work/$1.calls" "$program" run "$here/$1.yaml" --no-pictures --quiet \
    --db "$work/$1.db" >"$work/$1.log" 2>&1 || {
    tail -n 3 "$work/$1.log"
    exit 1
  }
  grep -oE '^c?fn=\([0-9]+\) .*' "$work/$1.calls" | sed 's/^[^ ]* //' | sort -u >"$work/$1"
}
# Prints how often a run calls a function.
times() { # FUNCTION RUN
  awk -v f="morula::$1(" '/^cfn=/ { name = $1; sub(/^cfn=/, "", name); if (index($0, f)) wanted = name }
       /^fn=/ { own = $1; sub(/^fn=/, "", own); if (index($0, f)) wanted = own }
       /^calls=/ { split($1, n, "="); called[name] += n[2] }
       END { print called[wanted] + 0 }' "$work/$2.calls"
}

calls full
calls plain
wrong=0
for function in $functions; do
  grep -qF "$function" "$work/full" || skip "this build has no $function to see"
  if grep -F "$function" "$work/plain"; then
    echo "CALLED, though plain.yaml does not ask for it: $function"
    wrong=1
  fi
done
echo "hashes of the state: $(times hashState plain), and $(times hashState full) where they are asked for"
[ "$(times hashState plain)" = 1 ] && [ "$(times hashState full)" -gt 1 ] || wrong=1
# Every run has a sample of its start and one of its end.
echo "samples: $(times measureCells plain), and $(times measureCells full) where they are asked for"
[ "$(times measureCells plain)" = 2 ] && [ "$(times measureCells full)" -gt 2 ] || wrong=1
exit $wrong

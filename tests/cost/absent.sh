#!/usr/bin/env bash
# What a scenario does not ask for is not called: of these functions a plain run calls none, and one that asks for
# everything calls each. Its state is hashed once, at the end, however long it is.
#
#   absent.sh MORULA
#
# Exit codes: 0 so it is, 1 not so, 77 skipped: no valgrind, or a compiler that leaves no function to see.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$1
functions='takeSnapshot addPairForces buildNeighbourList refreshList addConnectionForces driftVelocityVerlet<(morula::ShellShape)1>
  findTensions<true> addPressureForces<true> measureContactAreas morula::grow('

skip() {
  echo "skipped: $*"
  exit 77
}
command -v valgrind >/dev/null || skip "valgrind is not installed"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
valgrind --tool=none "$program" schema >"$work/log" 2>&1 || skip "the program does not run under valgrind here"

# Names of all functions that a run calls, each once, and how often it takes the state's hash.
calls() {
  valgrind --tool=callgrind --callgrind-out-file="$work/$1.calls" "$program" run "$here/$1.yaml" --no-pictures --quiet \
    --db "$work/$1.db" >"$work/$1.log" 2>&1 || {
    tail -n 3 "$work/$1.log"
    exit 1
  }
  grep -oE '^c?fn=\([0-9]+\) .*' "$work/$1.calls" | sed 's/^[^ ]* //' | sort -u >"$work/$1"
}
hashes() {
  awk '/^cfn=/ { name = $1; sub(/^cfn=/, "", name); if ($0 ~ /morula::hashState\(/) wanted = name }
       /^fn=/ { f = $1; sub(/^fn=/, "", f); if ($0 ~ /morula::hashState\(/) wanted = f }
       /^calls=/ { split($1, n, "="); called[name] += n[2] }
       END { print called[wanted] + 0 }' "$work/$1.calls"
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
echo "hashes of the state: $(hashes plain), and $(hashes full) where they are asked for"
[ "$(hashes plain)" = 1 ] && [ "$(hashes full)" -gt 1 ] || wrong=1
exit $wrong

#!/usr/bin/env bash
# Validating twice as many cells or mistakes on one line takes twice the instructions, not four times.
#
#   validate.sh MORULA
#
# Exit codes: 0 passed, 1 failed, 77 skipped: no valgrind.
set -euo pipefail
program=$1
skip() {
  echo "skipped: $*"
  exit 77
}
command -v valgrind >/dev/null || skip "valgrind is not installed"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
valgrind --tool=none "$program" schema >"$work/log" 2>&1 || skip "the program does not run under valgrind here"

instructions() { # FILE
  { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$program" validate "$1" 2>&1 || true; } |
    sed -n 's/.*Collected : //p'
}
cells() { # COUNT
  echo "{morula: 1, name: x, dna: 'START: a0', stop: {cycles: 1}, cells: [$(seq -s ', ' -f '{at: [%g, 0, 0]}' "$1")]}"
}
mistakes() { # COUNT
  echo "{$(head -c "$1" /dev/zero | tr '\0' ',')}"
}

for kind in cells mistakes; do
  counted=()
  for count in 500 1000 2000; do
    $kind $count >"$work/$kind.yaml"
    counted+=("$(instructions "$work/$kind.yaml")")
  done
  first=$((counted[1] - counted[0])) second=$((counted[2] - counted[1]))
  echo "$kind: 500, 1000 and 2000 take ${counted[*]} instructions"
  # The ratio of the two differences is 2 for linear cost, and 4 for quadratic cost.
  if ((second * 10 > first * 25)); then
    echo "$kind: from 1000 to 2000 $second more instructions, over 2.5 times the $first more from 500 to 1000"
    exit 1
  fi
done

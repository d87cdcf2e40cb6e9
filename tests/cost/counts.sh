#!/usr/bin/env bash
# Compares steps, searches and pairs with the accepted numbers, which must be equal.
#
#   counts.sh COST_PROGRAM
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
if difference=$(diff <(grep -v '^#' "$here/expected_counts.txt") <("$1" counts)); then
  echo "the same counts"
else
  echo "OTHER COUNTS (<: expected, >: here; scene, what, how many)"
  echo "$difference"
  echo "if that is meant: tests/cost/update.sh COST_PROGRAM \"why\""
  exit 1
fi

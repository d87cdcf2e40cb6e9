#!/usr/bin/env bash
# Compares the output of a command with expected_hashes.txt.
#
#   compare.sh NAME COMMAND...
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
name=$1
shift
if difference=$(diff <(grep -v '^#' "$here/expected_hashes.txt") <("$@")); then
  echo "the same bits: $name"
else
  echo "OTHER BITS: $name (<: expected, >: here; scene, steps, cells, hash of the whole run)"
  echo "$difference"
  exit 1
fi

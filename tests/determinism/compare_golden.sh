#!/usr/bin/env bash
# Compares the hashes of a shipped scenario's run, at the end and on the way, with those of its golden.
#
#   compare_golden.sh NAME SCENARIO SCENE COMMAND...
#
# SCENARIO: such as thesis/unique-four; SCENE: a file of write_scene; COMMAND: run_scene with its arguments.
# Exit codes: 0 equal, 1 different or missing.
set -euo pipefail
root=$(dirname "$(readlink -f "$0")")/../..
name=$1 scenario=$2 scene=$3
shift 3
golden=$root/golden/$scenario.golden
# Links of the chain also have short hashes of cells, which only locate differences.
if ! expected=$(grep -E '^(bits|step_hash) ' "$golden" | cut -d ' ' -f 1-3) || ! grep -q '^bits solver ' <<<"$expected"; then
  echo "golden/$scenario.golden has no hashes to compare with"
  exit 1
fi
actual=$("$@" "$scene" "$golden") || {
  echo "OTHER BITS: $name: $scenario: the run failed"
  exit 1
}
if difference=$(diff <(echo "$expected") <(echo "$actual")); then
  echo "the same bits: $name: $scenario and its golden"
else
  echo "OTHER BITS: $name: $scenario (<: its golden, >: here)"
  head -n 8 <<<"$difference"
  exit 1
fi

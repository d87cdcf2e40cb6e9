#!/usr/bin/env bash
# Compares the hashes of a shipped scenario's run, at the end and on the way, with those of its golden.
#
#   compare_golden.sh NAME SCENARIO SCENE COMMAND...
#
# SCENARIO: as thesis/unique-four; SCENE: written by write_scene; COMMAND: run_scene and what stands before and behind it.
# Exit codes: 0 the same, 1 others or none.
set -euo pipefail
root=$(dirname "$(readlink -f "$0")")/../..
name=$1 scenario=$2 scene=$3
shift 3
golden=$root/golden/$scenario.golden
# A link of the chain also has short hashes of cells, which tell where bits differ, not whether.
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

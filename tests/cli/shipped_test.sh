#!/usr/bin/env bash
# Runs the verbs that take any scenario with these scenarios. Each must succeed, or end as a scenario that must stop.
#
#   shipped_test.sh MORULA SCENARIO...
#
# Exit codes: 0 passed, 1 failed.
set -uo pipefail
morula=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
try() { # WORD...
  "$morula" "$@" --quiet >"$work/said" 2>&1
  local code=$?
  # A scenario that must stop may be refused (3) or stop on the way (4).
  if [ $code = 0 ] || { [ $stops = 1 ] && { [ $code = 3 ] || [ $code = 4 ]; }; }; then return; fi
  echo "exit $code: morula $*"
  tail -5 "$work/said"
  failures=1
}
drawn=0
for scenario; do
  stops=0
  grep -q '^  fails:' "$scenario" && stops=1
  try parts "$scenario" --rehearsal 1e4 --no-pictures # also validates the scenario
  try lineage "$scenario"
  try render "$scenario" --time 0 --size 64 --style lineage -o "$work/tree.png"
  grep -q '^physics:' "$scenario" || continue
  # Golden tests draw every organism; this test draws the first of a family that can be drawn.
  if [ $drawn = 0 ]; then try render "$scenario" --time 0 --size 64 -o "$work/start.png"; fi
  if [ -e "$work/start.png" ]; then drawn=1; fi
  # A scenario that settles at each step has no time step with an error. Runs on finer meshes, which would take most of
  # the time, are made only if they are quick.
  grep -q '^  integrator: quasi-static' "$scenario" || try accuracy "$scenario" --quick --budget 0.1 --out "$work"
done
exit $failures

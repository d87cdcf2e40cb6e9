#!/usr/bin/env bash
# The verbs that take any scenario take these: each ends well, or as a scenario that must stop may end.
#
#   shipped_test.sh MORULA SCENARIO...
#
# Exit codes: 0 so it is, 1 not so.
set -uo pipefail
morula=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
try() { # WORD...
  "$morula" "$@" --quiet >"$work/said" 2>&1
  local code=$?
  # What must stop may be refused (3) or stop on the way (4).
  if [ $code = 0 ] || { [ $stops = 1 ] && { [ $code = 3 ] || [ $code = 4 ]; }; }; then return; fi
  echo "exit $code: morula $*"
  tail -5 "$work/said"
  failures=1
}
drawn=0
for scenario; do
  stops=0
  grep -q '^  fails:' "$scenario" && stops=1
  try parts "$scenario" --rehearsal 1e4 --no-pictures # validates it, too
  try lineage "$scenario"
  try render "$scenario" --time 0 --size 64 --style lineage -o "$work/tree.png"
  grep -q '^physics:' "$scenario" || continue
  # Every organism is drawn where it is held against its golden; here the first of a family that can be.
  if [ $drawn = 0 ]; then try render "$scenario" --time 0 --size 64 -o "$work/start.png"; fi
  if [ -e "$work/start.png" ]; then drawn=1; fi
  # One that goes from rest to rest has no time step whose error could be measured. Runs on finer meshes, to which most of the
  # time would go, are made where they take little.
  grep -q '^  integrator: fire' "$scenario" || try accuracy "$scenario" --quick --budget 0.1 --out "$work"
done
exit $failures

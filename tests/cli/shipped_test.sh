#!/usr/bin/env bash
# The verbs that take any scenario take this one: each ends well, or as a scenario that must stop may end.
#
#   shipped_test.sh MORULA SCENARIO
#
# Exit codes: 0 so it is, 1 not so.
set -uo pipefail
morula=$1 scenario=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$morula" validate "$scenario" >"$work/said" 2>&1
valid=$?
stops=0
grep -q '^  fails:' "$scenario" && stops=1
bodies=1
grep -q '^physics:' "$scenario" || bodies=0
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
if [ $valid != 0 ] && [ $stops = 0 ]; then
  cat "$work/said"
  exit 1
fi
try parts "$scenario" --rehearsal 1e4 --no-pictures
try lineage "$scenario"
if [ $bodies = 1 ]; then
  try render "$scenario" --time 0 --size 64 -o "$work/start.png"
  # One that goes from rest to rest has no time step whose error could be measured.
  grep -q '^  integrator: fire' "$scenario" || try accuracy "$scenario" --quick --out "$work"
fi
try render "$scenario" --time 0 --size 64 --style lineage -o "$work/tree.png"
exit $failures

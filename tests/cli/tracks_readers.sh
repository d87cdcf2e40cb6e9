#!/usr/bin/env bash
# Reads tracks, graphs and tables of morula with programs of others: Zarr, networkx, jsonschema and pandas.
#
#   tracks_readers.sh MORULA
#
# Exit codes: 0 passed, 1 failed, 77 skipped: a reader is not installed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
morula=$1
python=/usr/bin/python3 # Debian's Python has Debian's modules

skip() {
  echo "skipped: $*"
  exit 77
}
[ -x $python ] || skip "python3 is not installed"
for module in zarr networkx jsonschema pandas; do
  $python -c "import $module" 2>/dev/null || skip "Python has no module $module"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Nine cells, of which one dies. Names need quotes in CSV, or have more bytes than letters; one is another cell's path.
cat >"$work/known.yaml" <<'YAML'
morula: 1
name: known
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(a2|a1,A)
  g4(divide|a1)
  g5(die|a2,A)
  g6(a3|a1,B)
  g7(divide|a3,A)
stop: {time: 3.75}
names: {egg: P0, cells: {A: "Z,1", B: "Ωβ", BA: AB}}
physics: {mesh: {icosphere: 1}, drag: 5, contact: {}}
connections: {}
record: {every: 0.5, measures: [generation, contact_share]}
units: {length: µm, per-length: 27, time: min, per-time: 4}
YAML
sed '/^units/d; /^names/d; s/name: known/name: own/' "$work/known.yaml" >"$work/own.yaml"
for name in known own; do
  "$morula" run --quiet --no-pictures --db "$work/$name.db" "$work/$name.yaml" >/dev/null
  for format in tracks:csv geff:geff csv:tables; do
    "$morula" export "$work/$name.db" --format "${format%:*}" -o "$work/$name.${format#*:}" >/dev/null 2>>"$work/messages"
  done
  "$morula" lineage "$work/$name.db" --json >"$work/$name.json"
done
[ ! -s "$work/messages" ] || { cat "$work/messages"; echo "samples that are stored are exported without a word"; exit 1; }
"$python" "$here/tracks_readers.py" "$work" "$here/geff.schema.json"

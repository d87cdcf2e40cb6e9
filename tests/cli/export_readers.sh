#!/usr/bin/env bash
# Reads exports of morula with programs of others: VTK, Biopython and NumPy. Checks glTF against its specification, and
# CSV against the database.
#
#   export_readers.sh MORULA
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
for module in numpy vtkmodules.vtkIOXML Bio.Phylo; do
  $python -c "import $module" 2>/dev/null || skip "Python has no module $module"
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A scene of at most sixteen cells, one of which dies, with connections, contacts, a name that needs quotes, and
# measures on demand.
cat >"$work/kept.yaml" <<'YAML'
morula: 1
name: kept
seed: 3
dna: |
  START: a0
  g1(a1|a0)
  g2(divide|a0)
  g3(a2|a1,A)
  g4(a3|a1,B)
  g5(divide|a1)
  g6(die|a2,A)
  g7(a4|a2,B)
  g8(divide|a3,A)
  g9(a5|a3)
stop: {time: 4.25}
colours: {a1: '#e41a1c', a3: '#377eb8', a4: '#4daf4a', a5: '#ff7f00'}
names: {egg: P0, cells: {A: "AB", B: "P_1", BA: "E(x)"}}
variation: {cycle: 0.05}
physics:
  mesh: {icosphere: 3, coarsen: 0.3}
  cell: {radius: 0.95}
  drag: 2
  shell: {sphere: 1}
  contact: {}
connections: {}
record: {every: 0.5, meshes: 1, measures: [sister_contact, generation, contact_share]}
YAML
sed 's/name: kept/name: again/; s/ meshes: 1,//' "$work/kept.yaml" >"$work/again.yaml"
cat >"$work/gone.yaml" <<'YAML'
morula: 1
name: gone
dna: |
  START: a0
  g1(die|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 0}, drag: 2}
record: {every: 0.25, meshes: 0.25}
YAML
run() { "$morula" run --quiet --no-pictures --db "$work/$1.db" "$work/$1.yaml" "${@:2}" >/dev/null; }
export_as() { # DATABASE FORMAT PATH OPTIONS...
  "$morula" export "$work/$1.db" --format "$2" -o "$work/$3" "${@:4}" >>"$work/files" 2>>"$work/messages" || {
    tail -n 3 "$work/messages"
    exit 1
  }
}
run kept
run again
for format in newick vtk npz; do export_as kept $format "kept.$format"; done
export_as kept newick plain.newick --no-comments
export_as kept csv tables
export_as kept ply kept.ply
export_as kept ply kept.series
export_as kept gltf kept.glb --time 2
export_as kept csv cells.csv --table cells
run gone
for format in ply gltf vtk; do export_as gone $format "gone-$format"; done
[ ! -s "$work/messages" ] || { cat "$work/messages"; echo "a run that kept its surfaces says nothing"; exit 1; }
export_as again ply again.ply
export_as again npz again.npz
export_as again gltf again.glb --time 2
for told in "kept no surfaces" "simulating it again to its end at 4.25" "the end equals the stored one, bit for bit"; do
  [ "$(grep -c "$told" "$work/messages")" = 3 ] || { cat "$work/messages"; echo "not said three times: $told"; exit 1; }
done
run kept --seed 4 # a second run in the same database
export_as kept newick both.newick
export_as kept npz both.npz --time 1
export_as kept csv both.tables
"$python" "$here/export_readers.py" "$work"

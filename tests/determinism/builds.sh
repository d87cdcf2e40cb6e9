#!/usr/bin/env bash
# Builds the simulator with another compiler, or for another machine, and compares the hashes of its runs.
#
#   builds.sh BUILD DIRECTORY WRITE_SCENE     BUILD: see build_as.sh
#
# Exit codes: 0 equal, 1 different, 77 the compiler or the emulator is missing.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
name=$1 build=$2 write_scene=$3
case $name in
  aarch64-*) emulator=qemu-aarch64 ;;
  wasm-*) emulator=node ;;
  *) emulator= ;;
esac
if [ $emulator ] && ! command -v $emulator >/dev/null; then
  echo "$emulator is not installed: skipped"
  exit 77
fi
"$here/build_as.sh" "$name" "$build" hash_program run_scene
scene=$build/unique-four.scene
"$write_scene" "$here/../../scenarios/thesis/unique-four.yaml" >"$scene"
isas=$($emulator "$build/hash_program" --isas)
different=0
widest=${isas##*[[:space:]]}
one_by_one=scalar
if [[ $emulator == qemu-* ]]; then one_by_one=; fi # it takes minutes; the matrix includes it
for isa in $one_by_one $widest; do # one cell at a time, and the widest
  "$here/compare.sh" "$name, $isa" $emulator "$build/hash_program" --isa "$isa" || different=1
done
# Reading files and hashing do not depend on the instruction set.
"$here/compare_golden.sh" "$name, $isa" thesis/unique-four "$scene" $emulator "$build/run_scene" --isa "$isa" || different=1
exit $different

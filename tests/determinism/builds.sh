#!/usr/bin/env bash
# Builds the simulator by itself as one more compiler would, or for another machine, and compares the hashes of its runs.
#
#   builds.sh BUILD DIRECTORY WRITE_SCENE     BUILD: see build_as.sh
#
# Exit codes: 0 the same, 1 others, 77 this compiler, or what its programs run on, is not here.
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
if [[ $emulator == qemu-* ]]; then one_by_one=; fi # which takes minutes; the matrix has it
for isa in $one_by_one $widest; do # one cell at a time, and the widest
  "$here/compare.sh" "$name, $isa" $emulator "$build/hash_program" --isa "$isa" || different=1
done
# What is read from a file, and hashed on the way, is so in any instruction set.
"$here/compare_golden.sh" "$name, $isa" thesis/unique-four "$scene" $emulator "$build/run_scene" --isa "$isa" || different=1
exit $different

#!/usr/bin/env bash
# Builds the simulator by itself as one more compiler would and compares the hashes of its runs.
#
#   builds.sh gcc-O0|gcc-O2|gcc-O3-portable|clang-O2 BUILD_DIRECTORY
#
# Exit codes: 0 the same, 1 others, 77 this compiler is not here.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
name=$1 build=$2
case $name in
  gcc-*) compiler=g++ ;;
  clang-*) compiler=clang++ ;;
  *) echo "builds.sh: there is no build $name" >&2; exit 2 ;;
esac
if ! command -v $compiler >/dev/null; then
  echo "$compiler is not installed: skipped"
  exit 77
fi
flags=-O${name#*-O} flags=${flags%%-portable}
portable=OFF
case $name in *-portable) portable=ON ;; esac
cmake -S "$here" -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=$compiler -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" \
  -DMORULA_PORTABLE=$portable >"$build.log" 2>&1 && cmake --build "$build" --target hash_program >>"$build.log" 2>&1 || {
  tail -n 40 "$build.log"
  exit 1
}
"$here/compare.sh" "$name" "$build/hash_program"
"$here/compare.sh" "$name, one cell at a time" "$build/hash_program" --isa scalar

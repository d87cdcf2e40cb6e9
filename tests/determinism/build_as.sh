#!/usr/bin/env bash
# Builds programs of ours as another compiler would, with other options or for another machine.
#
#   build_as.sh BUILD DIRECTORY TARGET...
#
# BUILD: gcc-O0, gcc-O2, gcc-O3, clang-O2, clang-O3; clang-O0: each source compiled by itself; gcc-O2-avx2 and
# gcc-O2-avx512: every source compiled so, not the kernels alone; gcc-O3-portable: baseline kernels and no others;
# aarch64-O2: for that machine; wasm-O3: as WebAssembly, for Node.js, by core/wasm/build.sh, whose folder DIRECTORY is.
# TARGET: hash_program and run_scene, for which the simulator alone is built, or morula.
# What the compiler says goes into DIRECTORY.log. Exit codes: 0 built, 1 failed, 2 usage, 77 the compiler is not here.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
if [ $# -lt 3 ]; then
  sed -n '2,10s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
name=$1 build=$2
shift 2
flags=-O${name#*-O}
options=()
case $name in
  gcc-O[0-3] | gcc-O[0-3]-*) compiler=g++ ;;
  clang-O[0-3] | clang-O[0-3]-*) compiler=clang++ ;;
  aarch64-O[0-3]) compiler=aarch64-linux-gnu-g++ ;;
  wasm-O3) compiler=em++ ;;
  *) compiler= ;;
esac
# Never -mfma, nor an architecture that implies it: a fused multiply-add changes results.
case $name in
  aarch64-O?) options=(--toolchain "$here/aarch64.cmake" -DMORULA_THREADS=OFF) ;;
  clang-O0) options=(-DMORULA_UNITY=OFF) ;;
  *-O?) ;;
  *-portable) flags=${flags%-portable} options=(-DMORULA_PORTABLE=ON) ;;
  *-avx2) flags="${flags%-avx2} -mavx2" ;;
  *-avx512) flags="${flags%-avx512} -mavx512f -mavx512vl -mavx512dq" ;;
  *) compiler= ;;
esac
if [ -z "$compiler" ]; then
  echo "build_as.sh: there is no build $name" >&2
  exit 2
fi
if ! command -v $compiler >/dev/null; then
  echo "$compiler is not installed"
  exit 77
fi
case $name in aarch64-*) ;; *) options+=("-DCMAKE_CXX_COMPILER=$compiler") ;; esac
if [ "$1" = morula ]; then source=$here/../.. options+=(-DBUILD_TESTING=OFF); else source=$here; fi
mkdir -p "$(dirname "$build")"
compile() {
  if [ "$name" = wasm-O3 ]; then
    "$here/../../core/wasm/build.sh" "$build" "$@"
  else
    cmake -S "$source" -B "$build" -G Ninja "${options[@]}" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$flags" &&
      cmake --build "$build" --target "$@"
  fi
}
compile "$@" >"$build.log" 2>&1 || {
  if grep -q '^FAILED:' "$build.log"; then sed -n '/^FAILED:/,$p' "$build.log" | head -n 40; else tail -n 40 "$build.log"; fi
  exit 1
}

#!/bin/sh
# The simulator for pages, as WebAssembly:
#
#   build.sh FOLDER             makes FOLDER/morula.wasm.gz, and FOLDER/playground.wasm.gz if FOLDER/yaml-cpp holds the sources of
#                               yaml-cpp 0.7, unless they are as new as their sources
#   build.sh FOLDER PROGRAM...  makes FOLDER/PROGRAM for Node.js instead, of tests/determinism; the simulator is compiled once for both
#
# ./morula wasm calls this when it has installed what it needs. Exit codes: 0 it is there, 77 there is no emscripten, 1 it could not be
# built.
# shellcheck disable=SC3013  # every sh at hand has -nt
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
command -v em++ >/dev/null && command -v cmake >/dev/null || exit 77

# One at a time.
exec 8>"$folder/lock"
if command -v flock >/dev/null; then flock 8; fi

modules=morula
if [ -e "$folder/yaml-cpp/include" ]; then modules="morula playground"; fi
cmake -S "$here/../.." -B "$folder/build" -G Ninja --toolchain "$here/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release -DMORULA_CORE_ONLY=ON \
  -DMORULA_THREADS=OFF -DMORULA_YAML_CPP="$([ "$modules" = morula ] || echo "$folder/yaml-cpp")" >&2 || exit 1
for program; do
  cmake --build "$folder/build" --target "$program" >&2 || exit 1
done
if [ $# -gt 0 ]; then exit 0; fi
for module in $modules; do
  cmake --build "$folder/build" --target "${module}_wasm" >&2 || exit 1
  if [ ! -e "$folder/$module.wasm.gz" ] || [ "$folder/build/$module.wasm" -nt "$folder/$module.wasm.gz" ]; then
    gzip -9nc "$folder/build/$module.wasm" >"$folder/new"
    mv "$folder/new" "$folder/$module.wasm.gz"
  fi
done

#!/bin/sh
# The simulator for pages, as WebAssembly:
#
#   build.sh FOLDER     makes FOLDER/morula.wasm.gz, unless it is as new as its sources
#
# ./morula wasm calls this when it has installed what it needs. Exit codes: 0 it is there, 77 there is no emscripten, 1 it could not be
# built.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
command -v em++ >/dev/null && command -v cmake >/dev/null || exit 77

# One at a time.
exec 8>"$folder/lock"
if command -v flock >/dev/null; then flock 8; fi

cmake -S "$here/../.." -B "$folder/build" -G Ninja --toolchain "$here/toolchain.cmake" -DCMAKE_BUILD_TYPE=Release \
  -DMORULA_CORE_ONLY=ON -DMORULA_THREADS=OFF >&2 || exit 1
cmake --build "$folder/build" --target morula_wasm >&2 || exit 1
if [ ! -e "$folder/morula.wasm.gz" ] || [ "$folder/build/morula.wasm" -nt "$folder/morula.wasm.gz" ]; then
  gzip -9nc "$folder/build/morula.wasm" >"$folder/new"
  mv "$folder/new" "$folder/morula.wasm.gz"
fi

#!/usr/bin/env bash
# Tests that configuring refuses options that break the rules of arithmetic, wherever they are given.
#
#   fast_math.sh SOURCE_FOLDER
#
# Exit codes: 0 passed, 1 failed.
set -uo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
number=0
wrong=0
refused() { # NAME COMMAND...
  local said
  number=$((number + 1))
  if said=$("${@:2}" -S "$source" -B "$folder/$number" 2>&1); then
    echo "$1 is accepted"
    wrong=1
  elif ! tr -s ' \n' ' ' <<<"$said" | grep -q "$1 has -[a-zO-]*, with which results are not the same bits"; then
    echo "$1: something else is wrong: $said"
    wrong=1
  fi
}
source=$1
refused CMAKE_CXX_FLAGS cmake -DCMAKE_CXX_FLAGS="-g -ffast-math"
refused CMAKE_CXX_FLAGS env CXXFLAGS=-Ofast cmake
refused CMAKE_EXE_LINKER_FLAGS env LDFLAGS=-ffast-math cmake
exit $wrong

#!/usr/bin/env bash
# Tests that ccache tells edits of precompiled headers apart, even if a folder holds an older precompiled header. gcc
# reads the older one instead of the headers, so ccache would take two edits for the same. And gcc knows a header that it
# has precompiled by all of its text, so that after the edit of a comment alone it would be included twice.
#
#   precompiled.sh COMPILE.SH COMPILER    the launcher that CMakeLists.txt writes
#
# Exit codes: 0 passed, 1 failed, 77 no ccache, or another compiler than gcc.
set -euo pipefail
launcher=$1
compiler=$2
if [ ! -e "$launcher" ] || ! "$compiler" --version | grep -q 'Free Software Foundation'; then
  echo "not tried: no ccache, or no gcc"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export CCACHE_DIR=$work/cache
unset CCACHE_DISABLE
precompile() { # FOLDER COMMAND...: precompiles the folder's headers as CMake does
  (cd "$1" && "${@:2}" "$compiler" -x c++-header -include all.h -o all.h.gch -c all.cxx)
}
value() { # prints the value that a source with the precompiled header has
  (cd "$1" && printf 'int main() { return value; }\n' >use.cpp && "$compiler" -Winvalid-pch -Werror -include all.h use.cpp -o use &&
    if ./use; then echo 0; else echo $?; fi)
}
# Prints 0 if a precompiled header whose comment has been edited still stands for it.
comment() {
  local folder
  for folder in one two; do
    mkdir -p "$work/$folder"
    printf '#include "value.h"\n' >"$work/$folder/all.h"
    : >"$work/$folder/all.cxx"
    printf '#pragma once\nconstexpr int value = 0;  // %s\n' "$folder" >"$work/$folder/value.h"
    printf '#include "value.h"\nint main() { return value; }\n' >"$work/$folder/again.cpp"
    precompile "$work/$folder" "$@"
  done
  (cd "$work/two" && if "$compiler" -include all.h again.cpp -o again 2>/dev/null; then echo 0; else echo $?; fi)
}
# Two folders begin alike, and each gets its own edit.
try() { # prints the second folder's value
  local folder
  for folder in one two; do
    rm -rf "${work:?}/$folder"
    mkdir "$work/$folder"
    printf '#include "value.h"\n' >"$work/$folder/all.h"
    : >"$work/$folder/all.cxx"
    printf 'constexpr int value = 1;\n' >"$work/$folder/value.h"
  done
  precompile "$work/one" "$@"
  cp -p "$work/one/all.h.gch" "$work/two/"
  printf 'constexpr int value = 2;\n' >"$work/one/value.h"
  precompile "$work/one" "$@"
  printf 'constexpr int value = 3;\n' >"$work/two/value.h"
  precompile "$work/two" "$@"
  value "$work/two"
}
planted=$(try env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1 ccache)
if [ "$planted" = 3 ]; then echo "note: this ccache does not have the fault; the launcher is not needed for it"; fi
rm -rf "$CCACHE_DIR"
if [ "$(comment sh "$launcher")" != 0 ]; then
  echo "a header is included twice after the edit of a comment: the precompiled header is of the former text"
  exit 1
fi
rm -rf "$CCACHE_DIR"
seen=$(try sh "$launcher")
if [ "$seen" != 3 ]; then
  echo "the precompiled header holds the edit of another folder: value is $seen, not 3"
  exit 1
fi

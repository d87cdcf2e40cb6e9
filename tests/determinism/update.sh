#!/usr/bin/env bash
# Accepts new hashes, after a change that is meant to change results. Two compilers have to agree on them first.
#
#   tests/determinism/update.sh "why results change"
#
# The reason goes into the file; commit it together with the change.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
if [ $# -ne 1 ] || [ ${#1} -lt 10 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build() {
  cmake -S "$here" -B "$work/$1" -G Ninja -DCMAKE_CXX_COMPILER="$1" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS="$2" \
    >"$work/log" 2>&1 && cmake --build "$work/$1" --target hash_program >>"$work/log" 2>&1 || {
    tail -n 40 "$work/log" >&2
    exit 70
  }
}
build g++ -O2
"$work/g++/hash_program" >"$work/hashes"
"$work/g++/hash_program" --isa scalar --threads 3 | diff "$work/hashes" - || {
  echo "lanes and one cell at a time disagree: there is nothing to accept" >&2
  exit 1
}
if command -v clang++ >/dev/null; then
  build clang++ -O1
  "$work/clang++/hash_program" | diff "$work/hashes" - || {
    echo "g++ and clang++ disagree: there is nothing to accept" >&2
    exit 1
  }
fi
{
  echo "# scene, steps, cells, hash of the whole run. Any build on any machine must print these lines."
  echo "# Changed last because: $1"
  cat "$work/hashes"
} >"$here/expected_hashes.txt"
git -C "$here" --no-pager diff --stat -- expected_hashes.txt

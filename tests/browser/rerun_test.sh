#!/bin/sh
# Tests pages of `morula report --rerun` in a browser: rerun_test.sh PROGRAM. Exit code 77 without Chromium, Node.js,
# npm or emscripten.
set -eu
# shellcheck source=tests/browser/setup.sh
. "$(dirname "$0")/setup.sh"
code=0
"$source/core/wasm/build.sh" "$build/wasm" >"$scratch/wasm.log" 2>&1 || code=$?
case $code in
  0) ;;
  77) echo "skipped: no emscripten" && exit 77 ;;
  *) tail -n 30 "$scratch/wasm.log" && exit 1 ;;
esac

page() { # page NAME SCENARIO OPTION...: the page NAME.html
  name=$1
  shift
  "$program" run "$@" --quiet --db "$scratch/$name.db" --out "$scratch/$name" >/dev/null
  "$program" report "$scratch/$name.db" -o "$scratch/$name.html" --frames 20 --rerun --quiet >/dev/null
}
page one scenarios/thesis/unique-four.yaml
page unchecked scenarios/thesis/unique-four.yaml --no-check --no-pictures
page lineage scenarios/worm/lineage.yaml
page single scenarios/hard/single-precision.yaml
"$program" report "$scratch/one.db" -o "$scratch/plain.html" --frames 2 --quiet >/dev/null
node "$here/rerun_test.mjs" "$build/explorer" "$scratch"

# Runs that a page cannot repeat are refused, and nothing is written.
refused() { # refused SAID ARGUMENT...
  said=$1
  shift
  if "$program" report "$@" -o "$scratch/none.html" >"$scratch/out" 2>&1 || [ -e "$scratch/none.html" ] ||
    ! grep -qF "$said" "$scratch/out"; then
    echo "FAILED: report $* does not say: $said" && cat "$scratch/out" && exit 1
  fi
}
refused 'this one has 2' --rerun "$scratch/one.db" "$scratch/lineage.db"

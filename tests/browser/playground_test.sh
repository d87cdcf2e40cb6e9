#!/bin/sh
# Tests the page of `morula playground` in a browser: playground_test.sh PROGRAM. Exit code 77 without Chromium,
# Node.js, npm, emscripten or the sources of yaml-cpp. MORULA_BROWSER_LARGE=1: all shipped and bad scenarios, not forty
# of each.
set -eu
# shellcheck source=tests/browser/setup.sh
. "$(dirname "$0")/setup.sh"
command -v em++ >/dev/null || { echo "skipped: no emscripten" && exit 77; }
if ! "$source/runner/input/browser/fetch_yaml.sh" "$build/wasm" >"$scratch/wasm.log" 2>&1; then
  tail -n 5 "$scratch/wasm.log"
  echo "skipped: the sources of yaml-cpp cannot be fetched"
  exit 77
fi
"$source/core/wasm/build.sh" "$build/wasm" >"$scratch/wasm.log" 2>&1 || { tail -n 30 "$scratch/wasm.log" && exit 1; }

"$program" playground -o "$scratch/playground.html" --quiet >/dev/null
node "$here/playground_test.mjs" "$build/explorer" "$scratch" "$source"

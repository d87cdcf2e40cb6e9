# shellcheck shell=sh
# The beginning of tests of pages in a browser, which read this file by `.` with PROGRAM as their first argument. Sets
# source (the folder of all sources), program, build (its folder), scratch (a temporary folder), NODE_PATH and CHROMIUM.
# Builds the explorer with its tests' packages, and changes to the sources. Exit code 77 without Chromium, Node.js or
# npm.
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
program=$1
build=$(dirname "$program")
CHROMIUM=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "skipped: no Chromium"
  exit 77
}
NODE_PATH=$build/explorer/node_modules
export CHROMIUM NODE_PATH
if ! "$source/reports/explorer/build.sh" "$build/explorer" --tests >"$build/explorer.log" 2>&1; then
  tail -n 5 "$build/explorer.log"
  echo "skipped: no Node.js, no npm, or its packages cannot be fetched"
  exit 77
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$source"

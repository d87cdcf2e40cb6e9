# shellcheck shell=sh
# What tests of pages in a browser begin with; they read it by `.`, with PROGRAM as their own first argument. Sets here, source (the folder
# of all sources), program, build (its folder), scratch (an empty folder that goes away) and NODE_PATH and CHROMIUM for Node.js;
# builds the explorer with what its tests need, and goes to the sources. Exit code 77 where there is no Chromium, Node.js or npm.
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

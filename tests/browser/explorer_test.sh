#!/bin/sh
# Pages of `morula report` in a browser: explorer_test.sh PROGRAM. 77 where there is no Chromium, Node.js or npm.
set -eu
program=$1
here=$(cd "$(dirname "$0")" && pwd)
source=$(cd "$here/../.." && pwd)
folder=$(dirname "$program")/explorer

chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || {
  echo "skipped: no Chromium"
  exit 77
}
code=0
"$source/reports/explorer/build.sh" "$folder" --tests >"$folder.log" 2>&1 || code=$?
if [ $code -ne 0 ]; then
  tail -n 5 "$folder.log"
  echo "skipped: no Node.js, no npm, or its packages cannot be fetched"
  exit 77
fi
cat >"$folder/tsconfig.json" <<END
{ "extends": "$source/reports/explorer/tsconfig.json",
  "compilerOptions": { "baseUrl": "$folder",
    "paths": { "three": ["node_modules/@types/three"], "three/*": ["node_modules/@types/three/*"] } },
  "include": ["$source/reports/explorer/src"] }
END
node "$folder/node_modules/typescript/bin/tsc" --noEmit -p "$folder/tsconfig.json"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$source"
"$program" run scenarios/thesis/unique-four.yaml --no-check --quiet --db "$scratch/one.db" --out "$scratch/one" >/dev/null
"$program" run scenarios/thesis/unique-four.yaml --set physics.pressure.constant=180 --quiet --db "$scratch/two.db" --out "$scratch/two" >/dev/null
"$program" report "$scratch/one.db" -o "$scratch/one.html" --frames 60 --quiet >/dev/null
"$program" report "$scratch/one.db" "$scratch/two.db" -o "$scratch/two.html" --frames 20 --quiet >/dev/null
mkdir -p "$scratch/evil"
"$program" run "$here/evil.yaml" --quiet --db "$scratch/evil.db" --out "$scratch/evil" >/dev/null
"$program" report "$scratch/evil.db" -o "$scratch/evil.html" --frames 5 --quiet >/dev/null
NODE_PATH=$folder/node_modules CHROMIUM=$chromium node "$here/explorer_test.mjs" "$folder" "$scratch"

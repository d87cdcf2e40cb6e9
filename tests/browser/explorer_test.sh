#!/bin/sh
# Tests pages of `morula report` in a browser: explorer_test.sh PROGRAM. Exit code 77 without Chromium, Node.js or npm.
set -eu
# shellcheck source=tests/browser/setup.sh
. "$(dirname "$0")/setup.sh"
folder=$build/explorer
cat >"$folder/tsconfig.json" <<END
{ "extends": "$source/reports/explorer/tsconfig.json",
  "compilerOptions": { "baseUrl": "$folder",
    "paths": { "three": ["node_modules/@types/three"], "three/*": ["node_modules/@types/three/*"],
      "uplot": ["node_modules/uplot/dist/uPlot.d.ts"] } },
  "include": ["$source/reports/explorer/src"] }
END
node "$folder/node_modules/typescript/bin/tsc" --noEmit --incremental --tsBuildInfoFile "$folder/types" -p "$folder/tsconfig.json"

node "$here/faces_test.mjs" "$folder" "$source/reports/explorer/src"

page() { # page NAME FRAMES WHAT...: makes the page NAME.html
  name=$1 frames=$2
  shift 2
  "$program" report "$@" -o "$scratch/$name.html" --frames "$frames" --quiet >/dev/null
}
run() { # run NAME SCENARIO OPTION...: makes the database NAME.db
  name=$1
  shift
  "$program" run "$@" --quiet --no-pictures --db "$scratch/$name.db" --out "$scratch/$name" >/dev/null
}
run one scenarios/thesis/unique-four.yaml --no-check
run two scenarios/thesis/unique-four.yaml --set physics.pressure.constant=180
run evil "$here/evil.yaml"
page one 60 "$scratch/one.db"
page two 20 "$scratch/one.db" "$scratch/two.db"
page evil 5 "$scratch/evil.db"

# A check that fails, because the accepted result had another pressure.
sed -e 's/^name: evil/name: small/' -e '/^summary:/d' "$here/evil.yaml" >"$scratch/small.yaml"
CI= "$program" review "$scratch/small.yaml" --accept --by tests --why 'to be held against' >/dev/null
sed -i 's/constant: 172/constant: 190/' "$scratch/small.yaml"
code=0
"$program" check "$scratch/small.yaml" --reports "$scratch/check" --quiet >/dev/null || code=$?
[ $code -eq 1 ] || { echo "FAILED: a check that must fail ends with $code" && exit 1; }
page check 20 "$scratch/check"

# A study of 150 runs.
cat >"$scratch/many.study.yaml" <<END
morula-study: 1
name: many
base: small.yaml
vary:
  drag:
    little: {physics.drag: 10}
    some: {physics.drag: 20}
    much: {physics.drag: 40}
seeds: 1..50
measures: [sphericity]
END
printf 'variation: {cycle: 0.05, start: 0.01}\n' >>"$scratch/small.yaml"
"$program" study run "$scratch/many.study.yaml" --out "$scratch/many" --no-predict --quiet >/dev/null
page study 11 "$scratch/many"

"$program" export "$scratch/one.db" --format ply -o "$scratch/last.ply" --quiet >/dev/null
node "$here/page_test.mjs" "$folder" "$scratch" "$source/reports/explorer/src" one.html "$scratch/last.ply"
node "$here/page_test.mjs" "$folder" "$scratch" "$source/reports/explorer/src" study.html

files="one.html check.html study.html"
# The page of the largest run takes as long as all others together; MORULA_BROWSER_LARGE=1 includes it.
if [ -n "${MORULA_BROWSER_LARGE-}" ]; then
  run elegans scenarios/thesis/elegans-128.yaml --no-check
  page elegans 200 "$scratch/elegans.db"
  files="$files elegans.html"
fi
node "$here/explorer_test.mjs" "$folder" "$scratch" $files

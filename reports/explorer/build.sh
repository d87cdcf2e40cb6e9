#!/bin/sh
# Builds the explorer of the pages that `morula report` writes from the sources beside this script:
#
#   build.sh FOLDER [--tests]     makes FOLDER/explorer.js, rerun.js and playground.js, unless they are up to date
#
# FOLDER also gets the packages that package-lock.json names; with --tests those of tests, too.
# Exit codes: 0 built or up to date, 77 no Node.js or no npm, 1 failed.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
tests=${2-}

command -v node >/dev/null && command -v npm >/dev/null || exit 77

# Builds of one folder run one at a time.
exec 8>"$folder/lock"
if command -v flock >/dev/null; then flock 8; fi

has_packages() {
  cmp -s "$here/package-lock.json" "$folder/package-lock.json" && [ -e "$folder/installed" ] &&
    { [ -z "$tests" ] || [ -d "$folder/node_modules/axe-core" ]; }
}
if ! has_packages; then
  rm -f "$folder/installed"
  cp "$here/package.json" "$here/package-lock.json" "$folder"
  # Packages' scripts are not run; none needs one.
  (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund ${tests:+--include=dev} $([ -n "$tests" ] || echo --omit=dev)) >&2 || exit 1
  : >"$folder/installed"
fi

if [ ! -e "$folder/explorer.js" ] || [ -n "$(find "$here" -newer "$folder/explorer.js" -type f -print -quit)" ]; then
  node "$here/build.mjs" "$folder" >&2 || exit 1
fi

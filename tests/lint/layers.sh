#!/usr/bin/env bash
# Checks that a folder includes only itself and folders below, by the map in its house's README. Only one folder
# includes an external library, unless the map has a line `everywhere: name, name`. In modules with parts, a part
# includes lower parts of its module, by the map in the module's README, and any part of lower modules.
#
#   layers.sh HOUSE [HOUSE-BELOW...]      (core; runner core reports)
#
# Exit codes: 0 passed, 1 failed.
set -euo pipefail
house=$1
shift
# A map reads "base ← mesh ← physics ← contacts, connections, division ← simulation", on one or more lines.
block() { sed -n '/^```$/,/^```$/p' "$1"; }
map() { block "$1" | grep -E '^[a-z_]+(, [a-z_]+)* ←' | sed 's/─*//g; s/^/map\t/'; }
# Prints each folder of sources as MODULE PART; a folder with its own sources is both.
parts() { # HOUSE
  local module file
  for module in "$1"/*/; do
    module=$(basename "$module")
    file=$(find "$1/$module" -maxdepth 1 \( -name '*.h' -o -name '*.cpp' \) -print -quit)
    if [ -n "$file" ]; then
      printf '%s\t%s\n' "$module" "$module"
    else
      (cd "$1/$module" && find . -mindepth 2 \( -name '*.h' -o -name '*.cpp' \)) | sed -E "s|^\./([^/]*)/.*|$module\t\1|" | sort -u
    fi
  done
}
map "$house/README.md" >/dev/null || {
  echo "$house/README.md has no map: lines as base ← mesh ← physics"
  exit 1
}
{
  map "$house/README.md"
  block "$house/README.md" | sed -n 's/^everywhere: /everywhere\t/p'
  for below in "$@"; do parts "$below" | sed 's/^/below\t/'; done
  parts "$house" | sed 's/^/part\t/'
  for module in $(parts "$house" | awk '$1 != $2 { print $1 }' | sort -u); do
    if [ -e "$house/$module/README.md" ]; then map "$house/$module/README.md" || :; fi
  done
  (cd "$house" && grep -rnE '^ *# *include' --include='*.h' --include='*.cpp' .) |
    sed -E 's|^\./||; s|^([^:]*:[0-9]*):|include\t\1\t|'
} | awk -F '\t' '
function wrong(text) { print text; ++errors }
$1 == "map" {
  floors = split($2, floor, / *← */)
  for (i = 1; i <= floors; ++i) {
    n = split(floor[i], name, /, */)
    for (j = 1; j <= n; ++j) { known[name[j]] = 1; for (k in seen) below[name[j], k] = 1 }
    for (j = 1; j <= n; ++j) seen[name[j]] = 1
  }
  delete seen
}
$1 == "everywhere" { n = split($2, name, /, */); for (j = 1; j <= n; ++j) everywhere[name[j]] = 1 }
$1 == "below" { outside[$3] = 1 }
$1 == "part" { moduleOf[$3] = $2; ++partsOf[$2]; ++parts }
$1 == "include" {
  if (!closed) {  # `below` is transitive
    for (k in known) for (i in known) for (j in known)
      if (((i, k) in below) && ((k, j) in below)) below[i, j] = 1
    closed = 1
  }
  file = $2; n = split(file, way, "/"); part = way[1] in moduleOf && moduleOf[way[1]] == way[1] ? way[1] : way[2]; module = way[1]
  what = $3; sub(/^ *# *include *["<]/, "", what); sub(/[">].*/, "", what)
  if ($3 ~ /"/) {
    to = what; if (!sub(/\/.*/, "", to)) { wrong(file ": \"" what "\" does not say of which folder it is"); next }
    if (to == part || (to in outside)) next
    across = to in moduleOf && moduleOf[to] != module
    from = across ? module : part
    onto = across ? moduleOf[to] : to
    if (!((from, onto) in below)) wrong(file ": " part " includes \"" what "\", but " onto " is not below " from)
  } else if (what ~ /\// && what !~ /^sys\//) {  # a library; of the standard library only sys/ has a folder
    library = what; sub(/\/.*/, "", library)
    if (library in user && user[library] != module && !(library in everywhere))
      wrong(file ": <" what ">: " user[library] " includes " library " already, and one folder may")
    user[library] = module
  }
}
END {
  for (p in moduleOf) {
    if (!(moduleOf[p] in known)) wrong(moduleOf[p] ": a folder that the map does not have")
    if (partsOf[moduleOf[p]] > 1 && !(p in known)) wrong(moduleOf[p] "/" p ": a part that the map of " moduleOf[p] " does not have")
  }
  if (errors || !parts) exit 1
  print parts " folders, each on top of those below it"
}'

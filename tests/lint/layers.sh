#!/usr/bin/env bash
# A room of the core includes only itself and rooms below it, as the map in its README says, and a library from outside
# is included by one room only.
#
#   layers.sh CORE
#
# Exit codes: 0 so it is, 1 not so.
set -euo pipefail
core=$1
# The map: "base ← mesh ← physics ← contacts, connections, division ← simulation", as many lines as it has.
map=$(sed -n '/^```$/,/^```$/p' "$core/README.md" | grep -E '^[a-z]+ ←' | sed 's/─*//g') || {
  echo "$core/README.md has no map: lines as base ← mesh ← physics"
  exit 1
}
cd "$core"
{
  awk '{ print "map\t" $0 }' <<<"$map"
  grep -rnE '^ *# *include' --include='*.h' --include='*.cpp' . | sed -E 's|^\./||; s|^([^:]*:[0-9]*):|include\t\1\t|'
  find . -mindepth 2 \( -name '*.h' -o -name '*.cpp' \) | sed -E 's|^\./([^/]*)/.*|room\t\1|' | sort -u
} | awk -F '\t' '
$1 == "map" {
  floors = split($2, floor, / *← */)
  for (i = 1; i <= floors; ++i) {
    n = split(floor[i], name, /, */)
    for (j = 1; j <= n; ++j) { known[name[j]] = 1; for (k in seen) below[name[j], k] = 1 }
    for (j = 1; j <= n; ++j) seen[name[j]] = 1
  }
  delete seen
}
$1 == "include" {
  file = $2; room = file; sub(/\/.*/, "", room)
  what = $3; sub(/^ *# *include *["<]/, "", what); sub(/[">].*/, "", what)
  if ($3 ~ /"/) {
    to = what; if (!sub(/\/.*/, "", to)) { print file ": \"" what "\" does not say of which room it is"; ++errors; next }
    if (to != room && !((room, to) in below)) { print file ": " room " includes \"" what "\", but " to " is not below it"; ++errors }
  } else if (what ~ /\//) {  # the standard library has no folders that we need
    library = what; sub(/\/.*/, "", library)
    if (library in user && user[library] != room) { print file ": <" what ">: " user[library] " includes " library " already, and one room may"; ++errors }
    user[library] = room
  }
}
$1 == "room" { if (!($2 in known)) { print $2 ": a room that the map does not have"; ++errors } ++rooms }
END { if (errors || !rooms) exit 1; print rooms " rooms, each on top of those below it" }'

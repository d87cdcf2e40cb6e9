#!/usr/bin/env bash
# A room includes only itself, rooms below it as the map in its house's README says, and rooms of the houses below; and a
# library from outside is included by one room only, unless the map has a line `everywhere: name, name`.
#
#   layers.sh HOUSE [HOUSE-BELOW...]      (core; runner core reports)
#
# Exit codes: 0 so it is, 1 not so.
set -euo pipefail
house=$1
shift
# The map: "base ← mesh ← physics ← contacts, connections, division ← simulation", as many lines as it has.
block=$(sed -n '/^```$/,/^```$/p' "$house/README.md")
map=$(grep -E '^[a-z_]+(, [a-z_]+)* ←' <<<"$block" | sed 's/─*//g') || {
  echo "$house/README.md has no map: lines as base ← mesh ← physics"
  exit 1
}
rooms() { find "$1" -mindepth 2 \( -name '*.h' -o -name '*.cpp' \) | sed -E "s|^$1/([^/]*)/.*|$2\t\1|" | sort -u; }
{
  awk '{ print "map\t" $0 }' <<<"$map"
  sed -n 's/^everywhere: /everywhere\t/p' <<<"$block"
  for below in "$@"; do rooms "$below" below; done
  rooms "$house" room
  (cd "$house" && grep -rnE '^ *# *include' --include='*.h' --include='*.cpp' .) |
    sed -E 's|^\./||; s|^([^:]*:[0-9]*):|include\t\1\t|'
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
$1 == "everywhere" { n = split($2, name, /, */); for (j = 1; j <= n; ++j) everywhere[name[j]] = 1 }
$1 == "below" { outside[$2] = 1 }
$1 == "room" { if (!($2 in known)) { print $2 ": a room that the map does not have"; ++errors } ++rooms }
$1 == "include" {
  if (!closed) {  # what is below a room below is below
    for (k in known) for (i in known) for (j in known)
      if (((i, k) in below) && ((k, j) in below)) below[i, j] = 1
    closed = 1
  }
  file = $2; room = file; sub(/\/.*/, "", room)
  what = $3; sub(/^ *# *include *["<]/, "", what); sub(/[">].*/, "", what)
  if ($3 ~ /"/) {
    to = what; if (!sub(/\/.*/, "", to)) { print file ": \"" what "\" does not say of which room it is"; ++errors; next }
    if (to != room && !((room, to) in below) && !(to in outside)) { print file ": " room " includes \"" what "\", but " to " is not below it"; ++errors }
  } else if (what ~ /\// && what !~ /^sys\//) {  # a library; the standard one has no other folders that we need
    library = what; sub(/\/.*/, "", library)
    if (library in user && user[library] != room && !(library in everywhere)) { print file ": <" what ">: " user[library] " includes " library " already, and one room may"; ++errors }
    user[library] = room
  }
}
END { if (errors || !rooms) exit 1; print rooms " rooms, each on top of those below it" }'

#!/usr/bin/env bash
# Checks that the core's sources have no match of banned_words.txt.
#
#   words.sh FILE_OR_FOLDER...
#
# Exit codes: 0 passed, 1 failed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
mapfile -t files < <(find "$@" -name '*.h' -o -name '*.cpp' | LC_ALL=C sort)
if [ ${#files[@]} -eq 0 ]; then
  echo "there is no source in: $*"
  exit 1
fi

# Prints "file:line:text" without comments and quoted text; names of headers stay.
bare() {
  awk 'FNR == 1 { inside = 0 }
  {
    line = $0
    if (inside) { if (!sub(/^.*\*\//, "", line)) line = ""; else inside = 0 }
    gsub(/\\["\\]/, "", line)
    if (line !~ /^ *#include/) gsub(/"[^"]*"/, "\"\"", line)
    sub(/\/\/.*/, "", line)
    gsub(/\/\*([^*]|\*[^\/])*\*\//, "", line)
    if (sub(/\/\*.*/, "", line)) inside = 1
    print FILENAME ":" FNR ":" line
  }' "$@"
}

sources=$(bare "${files[@]}")
wrong=0
while IFS=$'\t' read -r word why; do
  case $word in '#'* | '') continue ;; esac
  if found=$(grep -E "^[^:]*:[0-9]*:.*($word)" <<<"$sources"); then
    sed "s|\$|   <- $why|" <<<"$found"
    wrong=1
  fi
done <"$here/banned_words.txt"
[ $wrong = 1 ] || echo "${#files[@]} sources without a banned word"
exit $wrong

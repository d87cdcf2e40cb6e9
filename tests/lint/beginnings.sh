#!/usr/bin/env bash
# Finds comments whose first word continues a signature or an earlier comment.
#
#   beginnings.sh FILE_OR_FOLDER...
#
# Only the first line of a comment counts. Exit codes: 0 passed, 1 failed.
set -euo pipefail
mapfile -t files < <(find "$@" -name '*.h' -o -name '*.cpp' | LC_ALL=C sort)
if [ ${#files[@]} -eq 0 ]; then
  echo "there is no source in: $*"
  exit 1
fi
found=$(awk '
  FNR == 1 { inside = 0 }
  /^ *\/\// {
    if (!inside && $0 ~ /^ *\/\/\/? *(Of|Whether|What|The same|Those|As)[ ,:]/) print FILENAME ":" FNR ": " $0 "   <- begin with the subject, or with what the function does or returns"
    inside = 1
    next
  }
  { inside = 0 }' "${files[@]}")
if [ -n "$found" ]; then
  echo "$found"
  exit 1
fi
echo "${#files[@]} sources whose comments begin well"

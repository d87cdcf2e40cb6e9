#!/usr/bin/env bash
# Checks that the core calls nothing that may differ between machines; allowed_symbols.txt lists its external functions.
#
#   symbols.sh NM LIBRARY_OR_OBJECT...
#
# Exit codes: 0 passed, 1 failed.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
nm=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# A line of nm: an address (unless undefined), a letter, a name.
$nm -C "$@" | sed -nE 's/^[0-9a-f]* +([A-Za-z]) (.*)$/\1 \2/p' >"$work/all"
if [ ! -s "$work/all" ]; then
  echo "there is no symbol in: $*"
  exit 1
fi
sed -n 's/^[Uwv] //p' "$work/all" | LC_ALL=C sort -u >"$work/asked"
sed -n 's/^[^Uwv] //p' "$work/all" | LC_ALL=C sort -u >"$work/own"
sed -E '/^(#|$)/d' "$here/allowed_symbols.txt" >"$work/allowed"

wrong=0
while read -r name; do
  echo "NOT ALLOWED: $name"
  $nm -AC "$@" | grep -F " U $name" | sed -E 's/^.*\/([^/]*:[^ :]*):.*/  in \1/; s/: *U .*//' | head -n 3
  wrong=1
done < <(LC_ALL=C comm -23 "$work/asked" "$work/own" | grep -vxE -f "$work/allowed" || :)
# Standard templates whose results depend on the library are compiled into the core.
if grep -E 'std::(ranges::)?(__)?shuffle|_distribution|random_device|_engine<|unordered_|_Hashtable|std::chrono::' "$work/own"; then
  echo "NOT ALLOWED: the templates above"
  wrong=1
fi
[ $wrong = 1 ] || echo "$(wc -l <"$work/asked") names asked for, all of them allowed"
exit $wrong

#!/usr/bin/env bash
# The core calls nothing that may differ between machines: what it leaves to other libraries is in allowed_symbols.txt.
#
#   symbols.sh NM LIBRARY_OR_OBJECT...
#
# Exit codes: 0 so it is, 1 not so.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
nm=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Lines of nm: an address unless it is undefined, a letter, a name.
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
# Templates of the standard library whose results are each library's own are compiled into us.
if grep -E 'std::(ranges::)?(__)?shuffle|_distribution|random_device|_engine<|unordered_|_Hashtable|std::chrono::' "$work/own"; then
  echo "NOT ALLOWED: the templates above"
  wrong=1
fi
[ $wrong = 1 ] || echo "$(wc -l <"$work/asked") names asked for, all of them allowed"
exit $wrong

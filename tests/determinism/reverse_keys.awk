# A scenario with all its maps backward: the same meaning in another order.
#
#   awk -f reverse_keys.awk FILE
#
# Maps of the layout that scenarios have: keys at the margin and two columns in, maps on one line, blocks of text, lists
# of one map in each line below either. Maps over many lines stay as they are.

# Maps on one line that hold no other.
function turned(line, rest, done, n, i, item, map) {
  rest = line
  done = ""
  while (match(rest, /\{[^][{}]*\}/)) {
    n = split(substr(rest, RSTART + 1, RLENGTH - 2), item, /, */)
    map = item[n]
    for (i = n - 1; i >= 1; --i) map = map ", " item[i]
    done = done substr(rest, 1, RSTART - 1) "{" map "}"
    rest = substr(rest, RSTART + RLENGTH)
  }
  return done rest
}

/^#/ { next }
/^[^ ]/ {
  ++blocks
  head[blocks] = turned($0)
  text = /\|[ \t]*(#.*)?$/
  children = 0
  next
}
text { body[blocks] = body[blocks] "\n" $0; next }
/^  - / { body[blocks] = body[blocks] "\n" turned($0); next } # of a list, whose order means something
/^  [^] }]/ { child = ++children; own[blocks, child] = turned($0); count[blocks] = children; next }
{ own[blocks, child] = own[blocks, child] "\n" turned($0) }

END {
  for (i = blocks; i >= 1; --i) {
    print head[i] body[i]
    for (j = count[i]; j >= 1; --j) print own[i, j]
  }
}

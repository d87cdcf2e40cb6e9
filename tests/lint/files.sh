#!/usr/bin/env bash
# Only runner/platform/files opens files and asks the file system, and only runner/platform/system/console.cpp writes to
# standard output and error: there each file is checked for what it is, each failure gets its exit code, and each text loses what a terminal
# would obey.
#
#   files.sh RUNNER
#
# Exit codes: 0 so it is, 1 not so.
set -euo pipefail
cd "$1"
files='\b(w?[io]?fstream|fopen|freopen|creat|openat|mkstemp|mkdtemp|tmpfile)\b|(^|[^A-Za-z0-9_>])::(open|rename|unlink|remove|mkdir|stat|lstat) *\(|\bstd::rename\b|(filesystem|fs)::[a-z_]+_?(iterator)?'
silent='\bstd::(basic_)?[io]?stringstream\b|\bgetline\b'
streams='\bstd::(cout|cerr|clog)\b|\b(printf|fprintf|vprintf|puts|fputs|putchar|fwrite|perror)\b|\bfmt::print\b'
mapfile -t sources < <(find . -name '*.h' -o -name '*.cpp' | LC_ALL=C sort)
if [ ${#sources[@]} -eq 0 ]; then
  echo "there is no source in $1"
  exit 1
fi
wrong=0
look() { # ALLOWED PATTERN WHY: without comments; a path as a value asks nothing, nor does naming the namespace
  local found
  found=$(awk '{ line = $0; sub(/\/\/.*/, "", line); gsub(/"[^"]*"/, "\"\"", line); gsub(/(std::filesystem|fs)::path/, "", line)
                 print FILENAME ":" FNR ": " line }' "${sources[@]}" | sed 's|^\./||' | grep -vE "^($1)" | grep -E "^[^:]*:[0-9]*:.*($2)") || return 0
  sed "s|\$|   <- $3|" <<<"$found"
  wrong=1
}
# A child process's streams are set between fork and exec, where little may be called.
look 'platform/files/|platform/system/child_process\.cpp:' "$files" 'use files/read_file.h, write_file.h or folders.h'
look 'platform/system/console\.cpp:' "$streams" 'use system/console.h'
# Where no memory is left, a stream ends as if its text did. yaml-cpp reads nothing else.
look 'none:' 'directory_iterator' 'use files/folders.h: where no memory is left, these end the program'
look 'input/yaml/reader\.cpp:' "$silent" 'use files/text.h'
[ $wrong = 1 ] || echo "${#sources[@]} sources: files only through runner/platform/files, standard streams only through the console, texts without streams"
exit $wrong

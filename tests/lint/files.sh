#!/usr/bin/env bash
# Checks that only runner/platform/files opens files and asks the file system, and only
# runner/platform/system/console.cpp writes to standard output and error. These check the kind of each file, give each
# failure its exit code, and make visible the bytes that a terminal would obey.
#
#   files.sh RUNNER
#
# Exit codes: 0 passed, 1 failed.
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
look() { # ignores comments, paths as values, and the namespace's name
  local found
  found=$(awk '{ line = $0; sub(/\/\/.*/, "", line); gsub(/"[^"]*"/, "\"\"", line); gsub(/(std::filesystem|fs)::path/, "", line)
                 print FILENAME ":" FNR ": " line }' "${sources[@]}" | sed 's|^\./||' | grep -vE "^($1)" | grep -E "^[^:]*:[0-9]*:.*($2)") || return 0
  sed "s|\$|   <- $3|" <<<"$found"
  wrong=1
}
# A child process's streams are set between fork and exec, where few functions may be called.
look 'platform/files/|platform/system/child_process\.cpp:' "$files" 'use files/read_file.h, write_file.h or folders.h'
look 'platform/system/console\.cpp:' "$streams" 'use system/console.h'
# Without memory a stream ends as if its text did. Only yaml-cpp is read by streams.
look 'none:' 'directory_iterator' 'use files/folders.h: where no memory is left, these end the program'
look 'input/yaml/reader\.cpp:' "$silent" 'use files/text.h'
[ $wrong = 1 ] || echo "${#sources[@]} sources: files only through runner/platform/files, standard streams only through the console, texts without streams"
exit $wrong

#!/usr/bin/env bash
# Accepts other counts and instructions, after a change that is meant to change them.
#
#   tests/cost/update.sh COST_PROGRAM "why they change"
#
# The reason goes into the files, for the commit of the change. COST_PROGRAM: build/release/tests/cost/cost_program
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
if [ $# -ne 2 ] || [ ${#2} -lt 10 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
program=$1 why=$2
# Only changed numbers get the new reason.
accept() {
  local file=$here/$1 about=$2
  shift 2
  "$@" >"$file.new"
  if [ -e "$file" ] && diff -q <(grep -v '^#' "$file") "$file.new" >/dev/null; then
    rm "$file.new"
    return
  fi
  { echo "# $about" && echo "# Changed last because: $why" && cat "$file.new"; } >"$file"
  rm "$file.new"
}
accept expected_counts.txt "scene, what, how many. Any build on any machine must count the same." "$program" counts
accept expected_instructions.txt "kernel, instruction set, instructions per vertex and turn, within 5 %." \
  "$here/instructions.sh" "$program" --print
git -C "$here" --no-pager diff --stat -- .

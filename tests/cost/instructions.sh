#!/usr/bin/env bash
# Compares instructions per vertex and step with the accepted ones, within a tolerance. A gain must be accepted too, or
# a later loss would hide in it. Only the compiler that the file names is compared.
#
#   instructions.sh COST_PROGRAM            compares with expected_instructions.txt
#   instructions.sh COST_PROGRAM --print    prints the lines for this file
#
# Exit codes: 0 within, 1 not, 77 skipped: another build, no valgrind, or an instruction set that it does not know.
set -euo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$1 file=$here/expected_instructions.txt
turns=8 tolerance=5 # [%]

skip() {
  echo "skipped: $*"
  exit 77
}

# Prints the instructions per vertex of one kernel. Valgrind knows no AVX-512, and hides it from the program.
instructions() {
  local output=$work/$1-$2
  valgrind --tool=callgrind --callgrind-out-file=/dev/null --toggle-collect=countedWork \
    "$program" work "$1" "$2" $turns "$work" >"$output" 2>"$output.log" || return 1
  awk -v turns=$turns 'NR == FNR { vertices = $1; next } /Collected/ { printf "%.1f\n", $NF / vertices / turns }' \
    "$output" "$output.log"
}

command -v valgrind >/dev/null || skip "valgrind is not installed"
build=$("$program" build)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" work step scalar 1 "$work" >/dev/null # packs the cells, at full speed

if [ "${2-}" = --print ]; then
  echo "build $build"
  for isa in narrow avx2; do
    for kernel in $("$program" kernels); do echo "$kernel $isa $(instructions "$kernel" $isa)"; done
  done
  exit
fi

expected=$(sed -n 's/^build //p' "$file")
[ "$build" = "$expected" ] || skip "accepted for $expected, and this is $build"
failed=0
while read -r kernel isa accepted; do
  case $kernel in '#'* | build | '') continue ;; esac
  here=$(instructions "$kernel" "$isa") || {
    tail -n 3 "$work/$kernel-$isa.log"
    skip "$kernel with $isa does not run under valgrind here"
  }
  if awk -v a="$accepted" -v h="$here" -v t=$tolerance 'BEGIN { exit !(h <= a * (1 + t / 100) && h >= a * (1 - t / 100)) }'
  then verdict=fine
  else verdict="MORE THAN $tolerance % OFF" failed=1
  fi
  echo "$kernel $isa: $here instructions per vertex, accepted $accepted: $verdict"
done <"$file"
[ $failed = 0 ] || echo "if that is meant: tests/cost/update.sh COST_PROGRAM \"why\""
exit $failed

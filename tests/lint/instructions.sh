#!/usr/bin/env bash
# Checks that the core holds no fused and no approximate instruction.
#
#   instructions.sh OBJDUMP LIBRARY_OR_OBJECT...
#
# Exit codes: 0 passed, 1 failed.
set -euo pipefail
objdump=$1
shift
# x86: vfmadd… vfnmsub… vfmaddsub…, rcp, rsqrt.
# aarch64: fmadd, fnmsub, fmla, fmls, fcmla, frecpe, frsqrte and their steps.
$objdump -dC --no-show-raw-insn "$@" | awk -F '\t' '
/^[^ ].*: +file format/ { file = $0; sub(/: +file format.*/, "", file); sub(/.*\//, "", file) }
/^[0-9a-f]+ <.*>:$/ { function_ = $0; sub(/^[0-9a-f]+ </, "", function_); sub(/>:$/, "", function_) }
NF > 1 {
  ++instructions
  name = $2; sub(/[ \t].*/, "", name)
  if (name ~ /^vfn?m(add|sub)|^v?r(cp|sqrt)(14|28)?[ps][sdh]$|^fn?m(add|sub)$|^fml[as]|^fcmla|^fr(ecp|sqrt)/) {
    print "NOT ALLOWED: " name " in " file ", " function_; ++errors
  }
}
END {
  if (!instructions) { print "there is no instruction to look at"; exit 1 }
  if (errors) exit 1
  print instructions " instructions, none of them fused or approximate"
}'

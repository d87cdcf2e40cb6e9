#!/usr/bin/env bash
# Checks the compiler options of every source of the core: no contraction, and no option that changes results.
#
#   flags.sh COMPILE_COMMANDS_JSON FOLDER...     the folders of the core's sources, and of those that its build makes
#
# Exit codes: 0 passed, 1 failed.
set -euo pipefail
commands=$1
shift
folders=$(printf '%s\n' "$@") awk '
function isCore(file,   folder, n, i) {
  n = split(ENVIRON["folders"], folder, "\n")
  for (i = 1; i <= n; ++i) if (index(file, folder[i] "/") == 1) return 1
  return 0
}
function wrong(what) { print file ": " what; ++errors }
/^ *"command": / { command = $0; sub(/^ *"command": "/, "", command); sub(/",$/, "", command) }
/^ *"file": / {
  file = $0; sub(/^ *"file": "/, "", file); sub(/",?$/, "", file)
  if (!isCore(file)) next
  ++sources
  contraction = "not said"
  n = split(command, word, " ")
  for (i = 1; i <= n; ++i) {
    if (word[i] ~ /^-ffp-contract=/) contraction = word[i]
    else if (word[i] ~ /^(-Ofast|-ffast-math|-funsafe-math-optimizations|-fassociative-math|-freciprocal-math)$/ ||
             word[i] ~ /^(-ffinite-math-only|-fno-signed-zeros|-fsingle-precision-constant|-frounding-math|-ffp-model=.*)$/ ||
             word[i] ~ /^(-mrecip.*|-mfma4?|-mfpmath=387|-m32|-mcpu=.*)$/ ||
             word[i] ~ /^-march=/ && word[i] !~ /^-march=x86-64(-v2)?$/)  # -v3 and most names imply -mfma
      wrong("compiled with " word[i])
  }
  if (contraction != "-ffp-contract=off") wrong("compiled without -ffp-contract=off: " contraction)
}
END {
  if (!sources) { print "no source under " ENVIRON["folders"] " is compiled"; exit 1 }
  if (errors) exit 1
  print sources " compilations by the rules"
}' "$commands"

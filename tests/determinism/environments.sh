#!/usr/bin/env bash
# Runs one build in many environments: instruction sets, threads, addresses, heaps, locales, C library variants.
#
#   environments.sh HASH_PROGRAM
set -uo pipefail
here=$(dirname "$(readlink -f "$0")")
program=$1
different=0
same() { "$here/compare.sh" "$@" || different=1; }

same "as it is" "$program"
same "again, in another process" "$program"
for isa in $("$program" --isas); do
  same "instruction set $isa" "$program" --isa "$isa"
done
for threads in 2 3 7 16; do
  same "$threads threads" "$program" --threads $threads
done
# Some containers forbid setarch.
if setarch -R true 2>/dev/null; then same "addresses not random" setarch -R "$program"; fi
same "a heap full of rubbish" env MALLOC_PERTURB_=165 "$program"
same "an empty environment" env -i "$program"
same "a large environment" env "FILLER=$(head -c 100000 /dev/zero | tr '\0' x)" "$program"
same "a C library that knows no AVX2 and FMA" env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX512F "$program"
same "decimal commas" "$program" --comma
locales=$(mktemp -d)
trap 'rm -rf "$locales"' EXIT
if localedef -i de_DE -f UTF-8 "$locales/de_DE.UTF-8" 2>/dev/null; then
  same "a German locale" env LOCPATH="$locales" LC_ALL=de_DE.UTF-8 "$program"
fi
exit $different

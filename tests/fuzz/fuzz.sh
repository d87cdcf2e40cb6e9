#!/usr/bin/env bash
# Reads random inputs guided by coverage, with address and undefined-behaviour sanitizers (clang, libFuzzer).
#
#   fuzz.sh SECONDS [READER…]    runs each reader for the whole time; fuzz_mutations 0 lists the readers
#
# Findings stay in build/fuzz/findings: put them into tests/fuzz/corpus/READER together with the correction.
# Exit code 1: a finding.
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,7p' "$0"; exit 2; }
root=$(readlink -f "$(dirname "$0")/../..")
seconds=$1
shift
cd "$root"
cmake --preset fuzz >/dev/null
cmake --build build/fuzz --target fuzz_readers fuzz_mutations
if [ $# = 0 ]; then mapfile -t readers < <(build/fuzz/tests/fuzz/fuzz_mutations 0 | awk '{print $1}'); else readers=("$@"); fi
mkdir -p build/fuzz/findings
# The quarantine of freed memory has 16 MB, not 256: overwriting 256 MB at once took a second on a busy machine.
export ASAN_OPTIONS=quarantine_size_mb=16
code=0
for reader in "${readers[@]}"; do
  corpus=build/fuzz/corpus/$reader
  mkdir -p "$corpus"
  build/fuzz/tests/fuzz/fuzz_mutations 0 "$reader" "$corpus" >/dev/null # writes the seeds into the corpus
  if [ -d "tests/fuzz/corpus/$reader" ]; then cp -n "tests/fuzz/corpus/$reader"/* "$corpus"; fi
  touch "build/fuzz/$reader.begun"
  MORULA_FUZZ=$reader build/fuzz/tests/fuzz/fuzz_readers -max_total_time="$seconds" -timeout=1 -max_len=20000 \
    -artifact_prefix="build/fuzz/findings/$reader-" -print_final_stats=1 "$corpus" 2>"build/fuzz/$reader.log" || code=1
  echo "$reader: $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$reader.log") executions," \
    "$(find build/fuzz/findings -name "$reader-*" -newer "build/fuzz/$reader.begun" | wc -l) findings"
done
exit $code

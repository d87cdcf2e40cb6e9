#!/usr/bin/env bash
# Builds everything with a sanitizer and runs the tests with it.
#
#   sanitizers.sh address|thread [CTEST OPTIONS…]    address: and undefined behaviour; -R NAME, -j N, --rerun-failed
#
# It leaves out tests that a sanitizer does not extend or support: other builds (determinism, install, lint, cost,
# mutation), use of memory (soak; a sanitizer keeps freed memory), pages and other programs (browser, scipy, studies),
# libraries that replace malloc (faults, some regressions/*), and golden/* with many seeds (organism).
# With thread, tests of a single thread run too. Exit code 1: a report, or another failed test. Reports are in
# build/address or build/thread, Testing/Temporary/LastTest.log.
set -euo pipefail
case "${1:-}" in
  address | thread) preset=$1 ;;
  *) sed -n '2,10p' "$0"; exit 2 ;;
esac
shift
cd "$(dirname "$(readlink -f "$0")")/.."
cmake --preset "$preset" >/dev/null
cmake --build "build/$preset"
# A report ends the process with an exit code that the program does not use.
# The check for use after return is off: it misaligns variables of 64 bytes, and the AVX-512 kernels crash.
export ASAN_OPTIONS=exitcode=99:detect_stack_use_after_return=0:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=exitcode=99:halt_on_error=1:suppressions="'$PWD/tests/thread_suppressions.txt'"
ctest --test-dir "build/$preset" --output-on-failure --timeout 7200 -j 2 \
  -E '^(cost|determinism|install|lint|mutation|browser|scipy|studies|faults|bench|organism|property/soak)' "$@"

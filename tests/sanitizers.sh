#!/usr/bin/env bash
# Builds everything with a sanitizer and runs the tests with it.
#
#   sanitizers.sh address|thread [CTEST OPTIONS…]    address: and undefined behaviour; -R NAME, -j N, --rerun-failed
#
# Left out is what a sanitizer says nothing new of, or cannot stand: other builds (determinism, install, lint, cost and
# mutation), how much memory is taken (soak; a sanitizer keeps what was freed), pages and other programs (browser,
# scipy, studies), libraries that replace malloc (faults, regressions/* with a preloaded one), and what golden/* runs
# once, over many seeds (organism). With thread, what runs in one thread only is tried all the same.
# Exit 1: a report, or another test that fails; the reports are in build/address or build/thread, Testing/Temporary/LastTest.log.
set -euo pipefail
case "${1:-}" in
  address | thread) preset=$1 ;;
  *) sed -n '2,10p' "$0"; exit 2 ;;
esac
shift
cd "$(dirname "$(readlink -f "$0")")/.."
cmake --preset "$preset" >/dev/null
cmake --build "build/$preset"
# A report ends the process with a code that none of the program's is.
# No search for uses of a stack frame after its return: it puts variables of 64 bytes where they are not aligned, and the
# AVX-512 kernels crash.
export ASAN_OPTIONS=exitcode=99:detect_stack_use_after_return=0:allocator_may_return_null=1
export UBSAN_OPTIONS=print_stacktrace=1
export TSAN_OPTIONS=exitcode=99:halt_on_error=1:suppressions="'$PWD/tests/thread_suppressions.txt'"
ctest --test-dir "build/$preset" --output-on-failure --timeout 7200 -j 2 \
  -E '^(cost|determinism|install|lint|mutation|browser|scipy|studies|faults|bench|organism|property/soak)' "$@"

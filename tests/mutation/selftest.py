#!/usr/bin/env python3
"""Tests that mutate.py mutates planted code, and nothing else. Compiles nothing."""
import sys

sys.dont_write_bytecode = True  # leaves no files beside the sources

import mutate

PLANTED = r'''#include <vector>  // 1 + 2
#define TWICE(x) (2 * \
                  (x) + 1)
/* if (a) b += 1; */
static_assert(sizeof(int) == 4, "4 < 5");
template <int n = 3, bool fast = true>
inline void prefetchNext(int edge) {
  __builtin_prefetch(place + 8 * edge);
}
std::map<int, std::array<char, 2>> kept;
const char* text = "1 + 2 < 3 \" && true"; char c = '+';
const auto raw = R"(x == y)";
int* pointer, &&moved, negative = -value;
MORULA_CHECK(n > 1, "never"); throw Error(a + b);
double plain(const double& v) {
  a = b + c; a = b - c; a = b * c; a = b / c;
  a = b < c; a = b <= c; a = b > c; a = b >= c; a = b == c; a = b != c;
  a = b && c; a = b || c; a = std::min(b, c); a = std::max<double>(b, c);
  a = true; a = false; a = 0; a = 7u; a = 0.5; a = 0.0; a = 1e-12;
  sum += part;
  factor *= part;
  call(part);
  if (b < (c)) done(); else other();
}
'''

EXPECTED = {  # mutants of each line from line 16 on
    16: ["b - c", "b + c", "b / c", "b * c"],
    17: ["b <= c", "b < c", "b >= c", "b > c", "b != c", "b == c"],
    18: ["b || c", "b && c", "std::max(b", "std::min<double>(b"],
    19: ["a = false", "a = true", "a = 1;", "a = 8u", "a = 0.25", "a = 1.0", "a = 5e-13"],
    20: ["sum -= part;", ";"],
    21: ["factor /= part;", ";"],
    22: [";"],
    23: ["if (b <= (c))", "if (!(b < (c)))"],
}

failures = []


def expect(true, what):
    if not true: failures.append(what)


mutants = mutate.mutants_of("planted.cpp", PLANTED)
for line, changed in EXPECTED.items():
    found = [m.new for m in mutants if m.line == line]
    expect(len(found) == len(changed), f"line {line}: {len(changed)} mutants are expected, not {found}")
    for part in changed: expect(any(part in new for new in found), f"line {line}: nothing with '{part}' in {found}")
for m in mutants: expect(m.line in EXPECTED, f"line {m.line} was mutated: {m.new}")
for m in mutants:
    mutated = PLANTED[:m.begin] + m.text + PLANTED[m.end:]
    expect(mutated.count("\n") == PLANTED.count("\n"), f"{m.new} changes more than a line")
    expect(sum(a != b for a, b in zip(mutated.splitlines(), PLANTED.splitlines())) == 1, f"{m.new} is not one change")

some = mutate.chosen(mutants, len(EXPECTED))
expect(some == mutate.chosen(list(reversed(mutants)), len(EXPECTED)), "the choice depends on the order")
expect({m.line for m in some} == set(EXPECTED), "not one mutant of each line")
expect(mutate.chosen(mutants, 1000) == mutants, "all are not all")

accepted = mutate.read_accepted("# a comment\n\na.cpp\n- a < b\n+ a <= b\nThe same\nat b\n\nb.cpp\n- x\n+ y\nwhy\n")
expect(accepted == {("a.cpp", "a < b", "a <= b"): "The same at b", ("b.cpp", "x", "y"): "why"}, f"read as {accepted}")
expect(mutate.read_accepted("# nothing\n") == {}, "an empty list is none")

python = sys.executable
expect(mutate.run([python, "-c", ""])[0] == "", "what ends well fails")
header = "'-' * 79 + '\\nA case\\n' + '-' * 79"
expect(mutate.run([python, "-c", f"print({header}); exit(1)"])[0] == "A case", "the case that failed is not named")
expect(mutate.run([python, "-c", "while True: pass"], cpu_limit=0.1)[0] == "hangs", "what hangs is not ended")
expect("SIGABRT" in mutate.run([python, "-c", "import os; os.abort()"])[0], "a crash is not told")

for target, count, guards in mutate.TARGETS:
    expect((mutate.ROOT / target).is_file(), f"{target} is not there")
    for guard in guards.split("|"):
        expect((mutate.ROOT / "tests/unit" / guard.split(":")[0]).is_dir(), f"{guard} is no test program")

print(*failures, sep="\n")
sys.exit(1 if failures else 0)

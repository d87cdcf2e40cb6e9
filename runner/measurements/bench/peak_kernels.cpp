// This file is compiled once per instruction set (core/kernels.cmake).
#include "bench/peak_kernels.h"

#include "base/lanes.h"

namespace morula::MORULA_ISA {
namespace {

#if MORULA_WIDTH == 1
using Register = double;
MORULA_INLINE Register fill(double a) { return a; }
#else
using Register = RawLanes;
MORULA_INLINE Register fill(double a) { return Lanes(a).v; }
#endif

/// Keeps the compiler from merging, reordering or vectorising over chains: the value must be in a register, and may
/// have changed.
MORULA_INLINE void touch(Register& a) {
#if defined(__x86_64__) && MORULA_WIDTH == 8
  asm volatile("" : "+v"(a));
#elif defined(__x86_64__)
  asm volatile("" : "+x"(a));
#elif defined(__aarch64__)
  asm volatile("" : "+w"(a));
#else
  asm volatile("" : "+m"(a));
#endif
}

double sum(Lanes a) {
  double values[width], total = 0;
  store(values, a);
  for (const double v : values) total += v;
  return total;
}

// A multiplication and an addition that depend on each other take six to eight cycles, and at best two of each begin
// per cycle. So many chains are needed, and no more fit into 16 registers beside their two constants. Each is a
// separate variable, since gcc keeps arrays of registers in memory.
constexpr int chains = 12;

double multiplyAdd(long turns) {
  const Register factor = fill(0.999999), term = fill(1e-6);
  Register a = fill(1.0), b = fill(1.1), c = fill(1.2), d = fill(1.3), e = fill(1.4), f = fill(1.5), g = fill(1.6),
           h = fill(1.7), i = fill(1.8), j = fill(1.9), k = fill(2.0), l = fill(2.1);
  const auto turn = [&](Register & r) __attribute__((always_inline)) {
    r = r * factor + term;
    touch(r);
  };
  for (long t = 0; t < turns; ++t) {
    turn(a), turn(b), turn(c), turn(d), turn(e), turn(f);
    turn(g), turn(h), turn(i), turn(j), turn(k), turn(l);
  }
  return sum(Lanes(a + b + c + d + e + f + g + h + i + j + k + l));
}

double divideRoot(long turns) {
  Register a = fill(1.5), b = fill(1.6), c = fill(1.7), d = fill(1.8);
  const Register two = fill(2.0);
  const auto turn = [&](Register & r) __attribute__((always_inline)) {
#if MORULA_WIDTH == 1
    r = two / sqrt(r);
#else
    r = two / sqrt(Lanes(r)).v;
#endif
    touch(r);
  };
  for (long t = 0; t < turns; ++t) turn(a), turn(b), turn(c), turn(d);
  return sum(Lanes(a + b + c + d));
}

void triad(double* a, const double* b, const double* c, std::size_t count) {
  const Lanes two = 2.0;
  for (std::size_t i = 0; i < count; i += 8)
    for (int k = 0; k < 8; k += width) store(a + i + k, load(b + i + k) + two * load(c + i + k));
}

// Instructions are five bytes long, as those of kernels are, or the cache of decoded ones would not hold the loop. The
// loop itself takes two more.
double issue(long turns) {
  for (long t = 0; t < turns; ++t)
#if defined(__x86_64__)
    asm volatile(".rept 64\n\tnopl 0(%rax,%rax,1)\n\t.endr");
#else
    asm volatile(".rept 64\n\tnop\n\t.endr");
#endif
  return static_cast<double>(turns);
}

}  // namespace

extern const PeakKernels peak;
const PeakKernels peak = {2 * chains * width, multiplyAdd, 4 * width, divideRoot, triad, 64 + 2, issue};

}  // namespace morula::MORULA_ISA

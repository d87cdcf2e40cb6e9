// Compiled once per instruction set (core/kernels.cmake).
#include "bench/peak_kernels.h"

#include "base/lanes.h"

namespace morula::MORULA_ISA {

namespace {

// A multiplication and an addition that depend on each other take about eight cycles, and two of each can
// begin per cycle at best: so many chains are needed, and no more fit into 16 registers with their two
// constants.
constexpr int chains = 12;

/// Keeps the compiler from merging, reordering or vectorising over chains: the value is in a register, and
/// anything may have happened to it.
MORULA_INLINE void touch(Lanes& a) {
#if MORULA_WIDTH == 1
  auto& v = a;
#else
  auto& v = a.v;
#endif
#if defined(__x86_64__) && MORULA_WIDTH == 8
  asm volatile("" : "+v"(v));
#elif defined(__x86_64__)
  asm volatile("" : "+x"(v));
#elif defined(__aarch64__)
  asm volatile("" : "+w"(v));
#else
  asm volatile("" : "+m"(v));
#endif
}

double sum(Lanes a) {
  double values[width], total = 0;
  store(values, a);
  for (const double v : values) total += v;
  return total;
}

double multiplyAdd(long turns) {
  const Lanes factor = 0.999999, term = 1e-6;
  Lanes a[chains];
  for (int i = 0; i < chains; ++i) a[i] = 1.0 + 0.01 * i;
  for (long t = 0; t < turns; ++t)
#pragma GCC unroll 12
    for (int i = 0; i < chains; ++i) {
      a[i] = a[i] * factor + term;
      touch(a[i]);
    }
  Lanes total = 0.0;
  for (int i = 0; i < chains; ++i) total += a[i];
  return sum(total);
}

double divideRoot(long turns) {
  Lanes a[4];
  for (int i = 0; i < 4; ++i) a[i] = 1.5 + 0.25 * i;
  for (long t = 0; t < turns; ++t)
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i) {
      a[i] = 2.0 / squareRoot(a[i]);
      touch(a[i]);
    }
  return sum(a[0] + a[1] + a[2] + a[3]);
}

void triad(double* a, const double* b, const double* c, std::size_t count) {
  const Lanes two = 2.0;
  for (std::size_t i = 0; i < count; i += 8)
    for (int k = 0; k < 8; k += width) store(a + i + k, load(b + i + k) + two * load(c + i + k));
}

}  // namespace

extern const PeakKernels peak;
const PeakKernels peak = {2 * chains * width, multiplyAdd, 4 * width, divideRoot, triad};

}  // namespace morula::MORULA_ISA

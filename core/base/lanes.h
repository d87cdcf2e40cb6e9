// Several cells side by side: the only file that knows SIMD. Only *_kernels.cpp files include it: each is compiled once per instruction set, with MORULA_ISA (a namespace) and MORULA_WIDTH set by the build, so that
// no inline function of one set can be linked into another.
//
// The determinism contract: every operation here is one IEEE 754 operation per lane, rounded to nearest, so lane k of
// any width computes what a double would. No fused multiply-add, no approximate reciprocal, no reassociation.
#pragma once
#include <cstdint>

#if MORULA_WIDTH > 1
#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif
#endif

#if defined(__FAST_MATH__)
#error "fast-math changes results: see core/README.md, 'Same bits'"
#endif

#define MORULA_INLINE inline __attribute__((always_inline))

namespace morula::MORULA_ISA {

constexpr int width = MORULA_WIDTH;

#if MORULA_WIDTH == 1

using Lanes = double;
using Mask = bool;
MORULA_INLINE Lanes load(const double* p) { return *p; }
MORULA_INLINE void store(double* p, Lanes a) { *p = a; }
MORULA_INLINE Lanes squareRoot(Lanes a) { return __builtin_sqrt(a); }
MORULA_INLINE Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
MORULA_INLINE bool any(Mask m) { return m; }

#else

typedef double RawLanes __attribute__((vector_size(MORULA_WIDTH * 8)));
typedef std::int64_t RawMask __attribute__((vector_size(MORULA_WIDTH * 8)));

struct Mask {
  RawMask v;
  friend MORULA_INLINE Mask operator&(Mask a, Mask b) { return {a.v & b.v}; }
};

struct Lanes {
  RawLanes v;
  Lanes() = default;
  MORULA_INLINE Lanes(RawLanes raw) : v(raw) {}
  MORULA_INLINE Lanes(double a) {
    for (int i = 0; i < MORULA_WIDTH; ++i) v[i] = a;
  }
  friend MORULA_INLINE Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend MORULA_INLINE Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend MORULA_INLINE Lanes operator-(Lanes a) { return -a.v; }
  friend MORULA_INLINE Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend MORULA_INLINE Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  MORULA_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
  MORULA_INLINE Lanes& operator-=(Lanes b) { return *this = *this - b; }
  friend MORULA_INLINE Mask operator>(Lanes a, Lanes b) { return {a.v > b.v}; }
  friend MORULA_INLINE Mask operator<(Lanes a, Lanes b) { return {a.v < b.v}; }
};

MORULA_INLINE Lanes load(const double* p) {
  Lanes a;
  __builtin_memcpy(&a.v, p, sizeof a.v);
  return a;
}
MORULA_INLINE void store(double* p, Lanes a) { __builtin_memcpy(p, &a.v, sizeof a.v); }

MORULA_INLINE Lanes squareRoot(Lanes a) {
#if defined(__x86_64__) && MORULA_WIDTH == 2
  return (RawLanes)_mm_sqrt_pd((__m128d)a.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 4
  return (RawLanes)_mm256_sqrt_pd((__m256d)a.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 8
  return (RawLanes)_mm512_sqrt_pd((__m512d)a.v);
#elif defined(__aarch64__) && MORULA_WIDTH == 2
  return (RawLanes)vsqrtq_f64((float64x2_t)a.v);
#else
  for (int i = 0; i < MORULA_WIDTH; ++i) a.v[i] = __builtin_sqrt(a.v[i]);
  return a;
#endif
}

MORULA_INLINE Lanes select(Mask m, Lanes a, Lanes b) { return m.v ? a.v : b.v; }

MORULA_INLINE bool any(Mask m) {
  std::int64_t bits = 0;
  for (int i = 0; i < MORULA_WIDTH; ++i) bits |= m.v[i];
  return bits != 0;
}

#endif

/// The larger one; b where they do not compare (as x86's maxpd).
MORULA_INLINE Lanes larger(Lanes a, Lanes b) { return select(a > b, a, b); }

}  // namespace morula::MORULA_ISA

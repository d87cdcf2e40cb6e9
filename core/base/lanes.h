// Several cells side by side: the only file that knows SIMD. Only *_kernels.cpp files include it: each is
// compiled once per instruction set, with MORULA_ISA (a namespace) and MORULA_WIDTH set by the build, so that
// no inline function of one set can be linked into another.
//
// The determinism contract: every operation here is one IEEE 754 operation per lane, rounded to nearest, so
// lane k of any width computes what a double would. No fused multiply-add, no approximate reciprocal, no
// reassociation.
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
MORULA_INLINE unsigned bits(Mask m) { return m; }

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
  friend MORULA_INLINE Mask operator!=(Lanes a, Lanes b) { return {a.v != b.v}; }
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

/// Bit i: lane i.
MORULA_INLINE unsigned bits(Mask m) {
#if defined(__x86_64__) && MORULA_WIDTH == 2
  return _mm_movemask_pd((__m128d)m.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 4
  return _mm256_movemask_pd((__m256d)m.v);
#elif defined(__x86_64__) && MORULA_WIDTH == 8
  return _mm512_movepi64_mask((__m512i)m.v);
#else
  unsigned b = 0;
  for (int i = 0; i < MORULA_WIDTH; ++i) b |= unsigned(m.v[i] & 1) << i;
  return b;
#endif
}

MORULA_INLINE bool any(Mask m) { return bits(m) != 0; }

#endif

// Rows: eight doubles in one cache line, read and written by index for neighbours that lie anywhere. Turning
// `width` rows into eight columns of lanes is a transposition in registers, not a gather.
#if MORULA_WIDTH == 1

MORULA_INLINE void loadRows(const double* rows, const std::int32_t* index, Lanes column[8]) {
  for (int c = 0; c < 8; ++c) column[c] = rows[std::int64_t(index[0]) * 8 + c];
}
MORULA_INLINE void storeRows(double* firstRow, const Lanes column[8]) {
  for (int c = 0; c < 8; ++c) firstRow[c] = column[c];
}
MORULA_INLINE Lanes packFloats(Lanes a, Lanes b) {
  const float both[2] = {static_cast<float>(a), static_cast<float>(b)};
  Lanes packed;
  __builtin_memcpy(&packed, both, sizeof packed);
  return packed;
}
MORULA_INLINE void unpackFloats(Lanes packed, Lanes& a, Lanes& b) {
  float both[2];
  __builtin_memcpy(both, &packed, sizeof both);
  a = both[0];
  b = both[1];
}

#else

#if MORULA_WIDTH == 2
#define MORULA_LOW(a, b) __builtin_shufflevector(a, b, 0, 2)
#define MORULA_HIGH(a, b) __builtin_shufflevector(a, b, 1, 3)
#elif MORULA_WIDTH == 4
#define MORULA_LOW(a, b) __builtin_shufflevector(a, b, 0, 4, 2, 6)
#define MORULA_HIGH(a, b) __builtin_shufflevector(a, b, 1, 5, 3, 7)
#define MORULA_FIRST_PAIRS(a, b) __builtin_shufflevector(a, b, 0, 1, 4, 5)
#define MORULA_LAST_PAIRS(a, b) __builtin_shufflevector(a, b, 2, 3, 6, 7)
#elif MORULA_WIDTH == 8
#define MORULA_LOW(a, b) __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14)
#define MORULA_HIGH(a, b) __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15)
#define MORULA_FIRST_PAIRS(a, b) __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)
#define MORULA_LAST_PAIRS(a, b) __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)
#endif

/// Four consecutive doubles of each of `width` rows ↔ four columns. Its own inverse for width ≥ 4.
#if MORULA_WIDTH >= 4
MORULA_INLINE void transposeFours(RawLanes a, RawLanes b, RawLanes c, RawLanes d, Lanes column[4]) {
  const RawLanes low = MORULA_LOW(a, b), high = MORULA_HIGH(a, b), low2 = MORULA_LOW(c, d),
                 high2 = MORULA_HIGH(c, d);
  column[0] = MORULA_FIRST_PAIRS(low, low2);
  column[1] = MORULA_FIRST_PAIRS(high, high2);
  column[2] = MORULA_LAST_PAIRS(low, low2);
  column[3] = MORULA_LAST_PAIRS(high, high2);
}
#endif

MORULA_INLINE void loadRows(const double* rows, const std::int32_t* index, Lanes column[8]) {
#if MORULA_WIDTH == 2
  for (int c = 0; c < 8; c += 2) {
    const RawLanes a = load(rows + std::int64_t(index[0]) * 8 + c).v,
                   b = load(rows + std::int64_t(index[1]) * 8 + c).v;
    column[c] = MORULA_LOW(a, b);
    column[c + 1] = MORULA_HIGH(a, b);
  }
#elif MORULA_WIDTH == 4
  for (int c = 0; c < 8; c += 4) {
    RawLanes r[4];
    for (int i = 0; i < 4; ++i) r[i] = load(rows + std::int64_t(index[i]) * 8 + c).v;
    transposeFours(r[0], r[1], r[2], r[3], column + c);
  }
#else
  typedef double Four __attribute__((vector_size(32)));
  for (int c = 0; c < 8; c += 4) {
    RawLanes r[4];
    for (int i = 0; i < 4; ++i) {
      Four first, second;  // rows i and i + 4, side by side
      __builtin_memcpy(&first, rows + std::int64_t(index[i]) * 8 + c, sizeof first);
      __builtin_memcpy(&second, rows + std::int64_t(index[i + 4]) * 8 + c, sizeof second);
      r[i] = __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
    }
    transposeFours(r[0], r[1], r[2], r[3], column + c);
  }
#endif
}

/// Writes `width` consecutive rows.
MORULA_INLINE void storeRows(double* firstRow, const Lanes column[8]) {
#if MORULA_WIDTH == 2
  for (int c = 0; c < 8; c += 2) {
    store(firstRow + c, MORULA_LOW(column[c].v, column[c + 1].v));
    store(firstRow + 8 + c, MORULA_HIGH(column[c].v, column[c + 1].v));
  }
#else
  for (int c = 0; c < 8; c += 4) {
    Lanes r[4];
    transposeFours(column[c].v, column[c + 1].v, column[c + 2].v, column[c + 3].v, r);
#if MORULA_WIDTH == 4
    for (int i = 0; i < 4; ++i) store(firstRow + 8 * i + c, r[i]);
#else
    for (int i = 0; i < 4; ++i) {
      const RawLanes v = r[i].v;
      const auto first = __builtin_shufflevector(v, v, 0, 1, 2, 3),
                 second = __builtin_shufflevector(v, v, 4, 5, 6, 7);
      __builtin_memcpy(firstRow + 8 * i + c, &first, sizeof first);
      __builtin_memcpy(firstRow + 8 * (i + 4) + c, &second, sizeof second);
    }
#endif
  }
#endif
}

typedef float FloatLanes __attribute__((vector_size(MORULA_WIDTH * 8)));
typedef float HalfFloatLanes __attribute__((vector_size(MORULA_WIDTH * 4)));

/// Two floats in the place of each double, rounded to nearest: a first, b second.
MORULA_INLINE Lanes packFloats(Lanes a, Lanes b) {
  const HalfFloatLanes first = __builtin_convertvector(a.v, HalfFloatLanes);
  const HalfFloatLanes second = __builtin_convertvector(b.v, HalfFloatLanes);
#if MORULA_WIDTH == 2
  const FloatLanes both = __builtin_shufflevector(first, second, 0, 2, 1, 3);
#elif MORULA_WIDTH == 4
  const FloatLanes both = __builtin_shufflevector(first, second, 0, 4, 1, 5, 2, 6, 3, 7);
#else
  const FloatLanes both =
      __builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15);
#endif
  Lanes packed;
  __builtin_memcpy(&packed.v, &both, sizeof both);
  return packed;
}

MORULA_INLINE void unpackFloats(Lanes packed, Lanes& a, Lanes& b) {
  FloatLanes both;
  __builtin_memcpy(&both, &packed.v, sizeof both);
#if MORULA_WIDTH == 2
  const HalfFloatLanes first = __builtin_shufflevector(both, both, 0, 2),
                       second = __builtin_shufflevector(both, both, 1, 3);
#elif MORULA_WIDTH == 4
  const HalfFloatLanes first = __builtin_shufflevector(both, both, 0, 2, 4, 6);
  const HalfFloatLanes second = __builtin_shufflevector(both, both, 1, 3, 5, 7);
#else
  const HalfFloatLanes first = __builtin_shufflevector(both, both, 0, 2, 4, 6, 8, 10, 12, 14);
  const HalfFloatLanes second = __builtin_shufflevector(both, both, 1, 3, 5, 7, 9, 11, 13, 15);
#endif
  a = Lanes(__builtin_convertvector(first, RawLanes));
  b = Lanes(__builtin_convertvector(second, RawLanes));
}

#endif

/// The larger one; b where they do not compare (as x86's maxpd).
MORULA_INLINE Lanes larger(Lanes a, Lanes b) { return select(a > b, a, b); }

}  // namespace morula::MORULA_ISA

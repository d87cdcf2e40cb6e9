#pragma once
// Rows of eight doubles. Read through rows_kernel.h.
#include "base/lanes.h"

namespace morula::MORULA_ISA {

constexpr int rowColumns = 8, rowStride = 8;

/// loadRows reads the rows of `width` indices as eight columns of lanes. packFloats and unpackFloats: two floats in the
/// place of one double, as a row holds its velocity. loadFloats and storeFloats: lanes as floats, rounded to nearest.
#if MORULA_WIDTH == 1

MORULA_INLINE void loadRows(const double* rows, const std::int32_t* index, Lanes column[rowColumns]) {
  for (int c = 0; c < 8; ++c) column[c] = rows[std::int64_t(index[0]) * 8 + c];
}
MORULA_INLINE void storeRows(double* firstRow, const Lanes column[rowColumns]) {
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
MORULA_INLINE Lanes loadFloats(const float* p) { return *p; }
MORULA_INLINE void storeFloats(float* p, Lanes a) { *p = static_cast<float>(a); }

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

/// Transposes four consecutive doubles of each of `width` rows ↔ four columns. Its own inverse for width ≥ 4.
#if MORULA_WIDTH >= 4
MORULA_INLINE void transposeFours(RawLanes a, RawLanes b, RawLanes c, RawLanes d, Lanes column[4]) {
  const RawLanes low = MORULA_LOW(a, b), high = MORULA_HIGH(a, b), low2 = MORULA_LOW(c, d), high2 = MORULA_HIGH(c, d);
  column[0] = MORULA_FIRST_PAIRS(low, low2);
  column[1] = MORULA_FIRST_PAIRS(high, high2);
  column[2] = MORULA_LAST_PAIRS(low, low2);
  column[3] = MORULA_LAST_PAIRS(high, high2);
}
#endif

MORULA_INLINE void loadRows(const double* rows, const std::int32_t* index, Lanes column[rowColumns]) {
#if MORULA_WIDTH == 2
  const double *first = rows + std::int64_t(index[0]) * 8, *second = rows + std::int64_t(index[1]) * 8;
  for (int c = 0; c < 8; c += 2) {
    const RawLanes a = load(first + c).v, b = load(second + c).v;
    column[c] = MORULA_LOW(a, b);
    column[c + 1] = MORULA_HIGH(a, b);
  }
#elif MORULA_WIDTH == 4
  const double* row[4];
  for (int i = 0; i < 4; ++i) row[i] = rows + std::int64_t(index[i]) * 8;
  for (int c = 0; c < 8; c += 4)
    transposeFours(load(row[0] + c).v, load(row[1] + c).v, load(row[2] + c).v, load(row[3] + c).v, column + c);
#else
  const double* row[8];
  for (int i = 0; i < 8; ++i) row[i] = rows + std::int64_t(index[i]) * 8;
  for (int c = 0; c < 8; c += 4) {
    RawLanes r[4];  // rows i and i + 4, side by side
    for (int i = 0; i < 4; ++i) {
      const __m512d first = _mm512_castpd256_pd512(_mm256_loadu_pd(row[i] + c));
      r[i] = (RawLanes)_mm512_insertf64x4(first, _mm256_loadu_pd(row[i + 4] + c), 1);
    }
    transposeFours(r[0], r[1], r[2], r[3], column + c);
  }
#endif
}

/// Writes `width` consecutive rows.
MORULA_INLINE void storeRows(double* firstRow, const Lanes column[rowColumns]) {
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
      const auto first = __builtin_shufflevector(v, v, 0, 1, 2, 3), second = __builtin_shufflevector(v, v, 4, 5, 6, 7);
      __builtin_memcpy(firstRow + 8 * i + c, &first, sizeof first);
      __builtin_memcpy(firstRow + 8 * (i + 4) + c, &second, sizeof second);
    }
#endif
  }
#endif
}

typedef float FloatLanes __attribute__((vector_size(MORULA_WIDTH * 8)));
typedef float HalfFloatLanes __attribute__((vector_size(MORULA_WIDTH * 4)));

/// Packs two floats into the place of each double, rounded to nearest: a first, b second.
MORULA_INLINE Lanes packFloats(Lanes a, Lanes b) {
  const HalfFloatLanes first = __builtin_convertvector(a.v, HalfFloatLanes);
  const HalfFloatLanes second = __builtin_convertvector(b.v, HalfFloatLanes);
#if MORULA_WIDTH == 2
  const FloatLanes both = __builtin_shufflevector(first, second, 0, 2, 1, 3);
#elif MORULA_WIDTH == 4
  const FloatLanes both = __builtin_shufflevector(first, second, 0, 4, 1, 5, 2, 6, 3, 7);
#else
  const FloatLanes both = __builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11, 4, 12, 5, 13, 6, 14, 7, 15);
#endif
  Lanes packed;
  __builtin_memcpy(&packed.v, &both, sizeof both);
  return packed;
}

// Uses intrinsics where there are some: compilers turn __builtin_convertvector into several conversions by way of
// memory.
MORULA_INLINE void unpackFloats(Lanes packed, Lanes& a, Lanes& b) {
  FloatLanes both;
  __builtin_memcpy(&both, &packed.v, sizeof both);
#if MORULA_WIDTH == 2 && defined(__SSE2__)
  a = Lanes(RawLanes(_mm_cvtps_pd(__builtin_shufflevector(both, both, 0, 2, 0, 2))));
  b = Lanes(RawLanes(_mm_cvtps_pd(__builtin_shufflevector(both, both, 1, 3, 1, 3))));
#elif MORULA_WIDTH == 2
  a = Lanes(__builtin_convertvector(__builtin_shufflevector(both, both, 0, 2), RawLanes));
  b = Lanes(__builtin_convertvector(__builtin_shufflevector(both, both, 1, 3), RawLanes));
#elif MORULA_WIDTH == 4
  const HalfFloatLanes low = __builtin_shufflevector(both, both, 0, 1, 2, 3),
                       high = __builtin_shufflevector(both, both, 4, 5, 6, 7);
  a = Lanes(RawLanes(_mm256_cvtps_pd(__builtin_shufflevector(low, high, 0, 2, 4, 6))));
  b = Lanes(RawLanes(_mm256_cvtps_pd(__builtin_shufflevector(low, high, 1, 3, 5, 7))));
#else
  a = Lanes(RawLanes(_mm512_cvtps_pd(__builtin_shufflevector(both, both, 0, 2, 4, 6, 8, 10, 12, 14))));
  b = Lanes(RawLanes(_mm512_cvtps_pd(__builtin_shufflevector(both, both, 1, 3, 5, 7, 9, 11, 13, 15))));
#endif
}

MORULA_INLINE Lanes loadFloats(const float* p) {
  HalfFloatLanes a;
  __builtin_memcpy(&a, p, sizeof a);
#if MORULA_WIDTH == 4
  return RawLanes(_mm256_cvtps_pd(a));
#elif MORULA_WIDTH == 8
  return RawLanes(_mm512_cvtps_pd(a));
#else
  return __builtin_convertvector(a, RawLanes);
#endif
}
MORULA_INLINE void storeFloats(float* p, Lanes a) {
  const HalfFloatLanes floats = __builtin_convertvector(a.v, HalfFloatLanes);
  __builtin_memcpy(p, &floats, sizeof floats);
}

#endif

}  // namespace morula::MORULA_ISA

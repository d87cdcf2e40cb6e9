#pragma once
// Rows of sixteen floats, of which the first twelve are in use. Read through rows_kernel.h.
#include "base/lanes.h"

namespace morula::MORULA_ISA {

constexpr int rowColumns = 12, rowStride = 16;

#if MORULA_WIDTH == 1

MORULA_INLINE void loadRows(const float* rows, const std::int32_t* index, Lanes column[rowColumns]) {
  for (int c = 0; c < rowColumns; ++c) column[c] = load(rows + std::int64_t(index[0]) * rowStride + c);
}
MORULA_INLINE void storeRows(float* firstRow, const Lanes column[rowColumns]) {
  for (int c = 0; c < rowColumns; ++c) store(firstRow + c, column[c]);
}

#else

#if MORULA_WIDTH == 4
#define MORULA_LOW(a, b) __builtin_shufflevector(a, b, 0, 4, 1, 5)
#define MORULA_HIGH(a, b) __builtin_shufflevector(a, b, 2, 6, 3, 7)
#define MORULA_FIRST_PAIRS(a, b) __builtin_shufflevector(a, b, 0, 1, 4, 5)
#define MORULA_LAST_PAIRS(a, b) __builtin_shufflevector(a, b, 2, 3, 6, 7)
#else
#define MORULA_LOW(a, b) __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13)
#define MORULA_HIGH(a, b) __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15)
#define MORULA_FIRST_PAIRS(a, b) __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)
#define MORULA_LAST_PAIRS(a, b) __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)
#endif

typedef float Four __attribute__((vector_size(16)));

/// Transposes four consecutive floats of four rows (of eight: i and i + 4 paired) ↔ four columns. Its own inverse.
MORULA_INLINE void transposeFours(const RawLanes row[4], Lanes column[4]) {
  const RawLanes low = MORULA_LOW(row[0], row[1]), high = MORULA_HIGH(row[0], row[1]),
                 low2 = MORULA_LOW(row[2], row[3]), high2 = MORULA_HIGH(row[2], row[3]);
  column[0] = MORULA_FIRST_PAIRS(low, low2);
  column[1] = MORULA_LAST_PAIRS(low, low2);
  column[2] = MORULA_FIRST_PAIRS(high, high2);
  column[3] = MORULA_LAST_PAIRS(high, high2);
}

MORULA_INLINE Four loadFour(const float* p) {
  Four a;
  __builtin_memcpy(&a, p, sizeof a);
  return a;
}

MORULA_INLINE void loadRows(const float* rows, const std::int32_t* index, Lanes column[rowColumns]) {
  const float* row[width];
  for (int i = 0; i < width; ++i) row[i] = rows + std::int64_t(index[i]) * rowStride;
  for (int c = 0; c < rowColumns; c += 4) {
    RawLanes r[4];
    for (int i = 0; i < 4; ++i) {
#if MORULA_WIDTH == 4
      r[i] = loadFour(row[i] + c);
#else
      r[i] = __builtin_shufflevector(loadFour(row[i] + c), loadFour(row[i + 4] + c), 0, 1, 2, 3, 4, 5, 6, 7);
#endif
    }
    transposeFours(r, column + c);
  }
}

/// Writes `width` consecutive rows.
MORULA_INLINE void storeRows(float* firstRow, const Lanes column[rowColumns]) {
  for (int c = 0; c < rowColumns; c += 4) {
    RawLanes columns[4];
    for (int i = 0; i < 4; ++i) columns[i] = column[c + i].v;
    Lanes r[4];
    transposeFours(columns, r);
    for (int i = 0; i < 4; ++i) {
#if MORULA_WIDTH == 4
      store(firstRow + rowStride * i + c, r[i]);
#else
      const RawLanes v = r[i].v;
      const Four first = __builtin_shufflevector(v, v, 0, 1, 2, 3), second = __builtin_shufflevector(v, v, 4, 5, 6, 7);
      __builtin_memcpy(firstRow + rowStride * i + c, &first, sizeof first);
      __builtin_memcpy(firstRow + rowStride * (i + 4) + c, &second, sizeof second);
#endif
    }
  }
}

#endif

MORULA_INLINE Lanes loadFloats(const float* p) { return load(p); }
MORULA_INLINE void storeFloats(float* p, Lanes a) { store(p, a); }

}  // namespace morula::MORULA_ISA

#pragma once
// Sorts short lists: each number's place is the number of smaller ones. That is n² comparisons, but many side by
// side and without a branch; a sort with branches pays for each that is mispredicted.
#include "base/lanes.h"
#include "contacts/search_kernels.h"

namespace morula::MORULA_ISA {

#if MORULA_WIDTH == 1
constexpr int intWidth = 1;
using Ints = std::int32_t;
MORULA_INLINE Ints oneIfLess(Ints a, Ints b) { return a < b; }
MORULA_INLINE Ints broadcast(std::int32_t a) { return a; }
#else
constexpr int intWidth = 2 * MORULA_WIDTH;
typedef std::int32_t Ints __attribute__((vector_size(MORULA_WIDTH * 8)));
MORULA_INLINE Ints oneIfLess(Ints a, Ints b) { return -(a < b); }
MORULA_INLINE Ints broadcast(std::int32_t a) { return a - Ints{}; }
#endif

/// [SearchKernels::sortShortList]
inline void sortShortList(std::int32_t* numbers, std::int32_t count) {
  std::int32_t unsorted[SearchKernels::longestShortList], place[SearchKernels::longestShortList];
  static_assert(SearchKernels::longestShortList % 16 == 0);
  __builtin_memcpy(unsorted, numbers, sizeof(std::int32_t) * static_cast<std::size_t>(count));
  for (std::int32_t i = count; i % intWidth != 0; ++i) unsorted[i] = 0;  // so that all numbers read have been written
  for (std::int32_t i = 0; i < count; i += intWidth) {
    Ints own, smaller{};
    __builtin_memcpy(&own, unsorted + i, sizeof own);
    for (std::int32_t k = 0; k < count; ++k) smaller += oneIfLess(broadcast(unsorted[k]), own);
    __builtin_memcpy(place + i, &smaller, sizeof smaller);
  }
  for (std::int32_t i = 0; i < count; ++i) numbers[place[i]] = unsorted[i];
}

}  // namespace morula::MORULA_ISA

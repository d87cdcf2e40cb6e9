#pragma once
// Prefetches memory that will be read soon. A processor predicts sequential reads by itself, but neither reads through
// a list of indices nor the jump from one block to the next.
#include "base/lanes.h"

namespace morula::MORULA_ISA {

/// Prefetches `bytes` bytes, from `from` bytes behind `place` on, into the second-level cache; the first stays free for
/// the work at hand. The place may lie behind the last block: prefetching memory that does not exist has no effect.
template <int bytes>
MORULA_INLINE void prefetch(const void* place, std::int64_t from) {
  const auto address = reinterpret_cast<std::uintptr_t>(place) + static_cast<std::uintptr_t>(from);
#pragma GCC unroll 16
  for (int line = 0; line < bytes; line += 64) __builtin_prefetch(reinterpret_cast<const void*>(address + line), 0, 2);
}

}  // namespace morula::MORULA_ISA

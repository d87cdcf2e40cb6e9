#pragma once
// Having brought near what will be read soon. A processor guesses streams by itself, but not that a list
// jumps, nor that after a block comes the next.
#include "base/lanes.h"

namespace morula::MORULA_ISA {

/// So many bytes, `from` bytes behind a place, into the second-level cache: there they wait until needed and
/// leave the first to the work at hand. It does not matter whether anything is there: behind the last block
/// nothing comes, and nothing happens.
template <int bytes>
MORULA_INLINE void fetch(const void* place, std::int64_t from) {
  const auto address = reinterpret_cast<std::uintptr_t>(place) + static_cast<std::uintptr_t>(from);
#pragma GCC unroll 16
  for (int line = 0; line < bytes; line += 64)
    __builtin_prefetch(reinterpret_cast<const void*>(address + line), 0, 2);
}

}  // namespace morula::MORULA_ISA

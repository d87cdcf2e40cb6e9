#pragma once
// Which points of the rows around a vertex are near. Hits are too irregular to be guessed by the processor,
// so nothing branches on them: all lanes' numbers are written, and the end of the list moves on by the hits.
#include "base/lanes.h"
#include "contacts/search_kernels.h"

namespace morula::MORULA_ISA {

/// For each set of four hits: which of the four they are, and how many.
struct Hits {
  std::int32_t which[4];
  std::int32_t count;
};
constexpr Hits hitsOf[16] = {{{}, 0},     {{0}, 1},       {{1}, 1},       {{0, 1}, 2},
                             {{2}, 1},    {{0, 2}, 2},    {{1, 2}, 2},    {{0, 1, 2}, 3},
                             {{3}, 1},    {{0, 3}, 2},    {{1, 3}, 2},    {{0, 1, 3}, 3},
                             {{2, 3}, 2}, {{0, 2, 3}, 3}, {{1, 2, 3}, 3}, {{0, 1, 2, 3}, 4}};

MORULA_INLINE std::int32_t writeHits(unsigned hits, const std::int32_t* vertex, std::int32_t* out) {
  std::int32_t found = 0;
  if constexpr (width >= 4) {
    for (int four = 0; four < width; four += 4) {
      const Hits& h = hitsOf[hits >> four & 15];
      for (int i = 0; i < 4; ++i) out[found + i] = vertex[four + h.which[i]];
      found += h.count;
    }
  } else {
    for (int i = 0; i < width; ++i) {
      out[found] = vertex[i];
      found += hits >> i & 1;
    }
  }
  return found;
}

/// [SearchKernels::findNear]
inline std::int32_t findNear(const NearQuery& q, std::int32_t* out) {
  std::int32_t found = 0;
  const Lanes px = q.px, py = q.py, pz = q.pz, own = q.ownSlot, ownHalf = q.ownHalfReach, skin = q.skin;
  for (int r = 0; r < q.rows; ++r) {
    const std::int32_t last = q.row[r].last;
    for (std::int32_t k = q.row[r].first; k < last; k += width) {
      const Lanes dx = load(q.x + k) - px, dy = load(q.y + k) - py, dz = load(q.z + k) - pz;
      const Lanes reach = (load(q.halfReach + k) + ownHalf) + skin;
      unsigned near = bits((dx * dx + dy * dy + dz * dz < reach * reach) & (load(q.slot + k) != own));
      const std::int32_t left = last - k;
      near &= left < width ? (1u << left) - 1 : ~0u;  // not what lies behind the row's end
      found += writeHits(near, q.vertex + k, out + found);
    }
  }
  return found;
}

}  // namespace morula::MORULA_ISA

#pragma once
// Finds the points near a vertex among the points of the rows around it. Rows are short, and a branch per hit would be
// unpredictable, so there is none: of eight points at a time all places are written, and the list's end advances by the
// number of hits.
#include "base/lanes.h"
#include "contacts/search_kernels.h"

namespace morula::MORULA_ISA {

typedef std::int32_t EightInts __attribute__((vector_size(32)));

/// A table that has for each set of hits among eight points their places and their number.
struct HitTable {
  std::int32_t which[256][8] = {};
  std::uint8_t count[256] = {};
  constexpr HitTable() {
    for (int hits = 0; hits < 256; ++hits)
      for (int i = 0; i < 8; ++i)
        if (hits >> i & 1) which[hits][count[hits]++] = i;
  }
};
inline constexpr HitTable hitTable;

/// [SearchKernels::findNear]
inline std::int32_t findNear(const NearQuery& q, std::int32_t* out) {
  std::int32_t found = 0;
  const Lanes px = q.px, py = q.py, pz = q.pz, own = q.ownSlot, ownHalf = q.ownHalfReach, skin = q.skin;
  for (int r = 0; r < q.rows; ++r) {
    const std::int32_t last = q.row[r].last;
    for (std::int32_t k = q.row[r].first; k < last; k += 8) {
      unsigned near = 0;
      for (int i = 0; i < 8; i += width) {
        const std::int32_t at = k + i;
        const Lanes dx = load(q.x + at) - px, dy = load(q.y + at) - py, dz = load(q.z + at) - pz;
        const Lanes reach = (load(q.halfReach + at) + ownHalf) + skin;
        near |= bits((dx * dx + dy * dy + dz * dz < reach * reach) & (load(q.slot + at) != own)) << i;
      }
      near &= (1u << (last - k < 8 ? last - k : 8)) - 1;  // without points behind the row's end
      EightInts places;
      __builtin_memcpy(&places, hitTable.which[near], sizeof places);
      places += k;
      __builtin_memcpy(out + found, &places, sizeof places);
      found += hitTable.count[near];
    }
  }
  for (std::int32_t i = 0; i < found; ++i) out[i] = q.vertex[out[i]];
  return found;
}

}  // namespace morula::MORULA_ISA

#pragma once
// The innermost loop of the neighbour search: which points of the rows of bins around a vertex are near.
#include "base/lanes.h"
#include "contacts/contacts_kernels.h"

namespace morula::MORULA_ISA {

/// [ContactKernels::findNear]
inline std::int32_t findNear(const NearQuery& q, std::int32_t* out) {
  std::int32_t found = 0;
  const Lanes px = q.px, py = q.py, pz = q.pz, own = q.ownSlot, reach = q.reachSquared;
  for (int r = 0; r < q.rows; ++r)
    for (std::int32_t k = q.row[r].first; k < q.row[r].last; k += width) {
      const Lanes dx = load(q.x + k) - px, dy = load(q.y + k) - py, dz = load(q.z + k) - pz;
      unsigned near = bits((dx * dx + dy * dy + dz * dz < reach) & (load(q.slot + k) != own));
      if (k + width > q.row[r].last)
        near &= (1u << (q.row[r].last - k)) - 1;  // what lies behind the row's end
      for (; near != 0; near &= near - 1) out[found++] = k + __builtin_ctz(near);
    }
  return found;
}

}  // namespace morula::MORULA_ISA

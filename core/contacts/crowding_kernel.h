#pragma once
// The crowding of a vertex among those that attract it, by which adhesion saturates (adhesion.h gives the formulas): a
// pass over the pairs before that of the forces, in scenes with adhesion only.
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// The numbers of a vertex that its pairs need: half of s, and q.
struct Saturation {
  Lanes half, turn;
};

MORULA_INLINE Saturation loadSaturation(const double* saturation, const VertexNumber* vertex) {
  Real half[width], turn[width];
  for (int i = 0; i < width; ++i) {
    const double* of = saturation + 2 * std::int64_t(vertex[i]);
    half[i] = static_cast<Real>(of[0]), turn[i] = static_cast<Real>(of[1]);
  }
  return {load(half), load(turn)};
}

/// Returns T_eff of a pair [energy]. Exchanging i and j changes no bit.
MORULA_INLINE Lanes saturate(Lanes strength, Lanes perWork, const Saturation& i, const Saturation& j) {
  return strength * (i.half + j.half) + perWork * (i.turn + j.turn);
}

/// [ContactKernels::findCrowding]
inline void findCrowding(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                         const ContactConstants& c, const double* areas, double* saturation) {
  constexpr double perReach = 1 / (attractionReach * attractionReach), perRoom = 1 / (3 * (maxHeld - 1));
  for (std::int64_t s = 0; s < block.count; ++s)
    for (int lane = 0; lane < blockLanes; lane += width) {
      const VertexNumber* vertex = block.slices[s].vertex + lane;
      const std::int32_t* index = indices + block.slices[s].start * blockLanes + lane;
      const Rows i = loadRows(rows, vertex);
      Lanes held = 0.0, density = 0.0;  // 12 e, 6 a ρ
      for (int k = 0; k < block.slices[s].length; ++k, index += blockLanes) {
        prefetchRows(rows, index);
        const Rows j = loadRows(rows, index);
        const Vec apart = j.x - i.x;
        const Lanes ratio = (0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared)) * dot(apart, apart);
        const Lanes m = 1.0 - dot(i.n, j.n), w = 1.0 - min(perReach * ratio, 1.0);
        const Lanes near = (0.25 * (m * m)) * (3.0 - m) * (w * (w * w));  // z w³
        held += load(c.adhesion + (index - indices)) * near;
        density += load(c.adhesionPerWork + (index - indices)) * near;
      }
      Real area[width];
      for (int l = 0; l < width; ++l)
        area[l] = static_cast<Real>(areas[static_cast<std::uint32_t>(vertex[l]) % blockLanes]);
      const Lanes inverse = 1.0 / load(area);
      const Lanes crowded = max((1.0 / 6) * (density * inverse), Lanes(1.0));  // ρ, at least 1: below it s is 1, s' 0
      const Lanes left = 1.0 - min(perRoom * (crowded - 1.0), 1.0), square = left * left, per = 1.0 / crowded;
      const Lanes share = (maxHeld - (maxHeld - 1) * (square * left)) * per;  // s
      const Lanes slope = select(crowded > Lanes(1.0), (square - share) * per, 0.0);
      Real halves[width], turns[width];
      store(halves, 0.5 * share), store(turns, ((1.0 / 12) * (held * inverse)) * slope);
      for (int l = 0; l < width; ++l) {
        if (vertex[l] >= c.vertices) continue;
        saturation[2 * std::int64_t(vertex[l])] = halves[l], saturation[2 * std::int64_t(vertex[l]) + 1] = turns[l];
      }
    }
}

}  // namespace morula::MORULA_ISA

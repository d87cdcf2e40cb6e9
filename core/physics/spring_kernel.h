#pragma once
// Damped springs along the mesh's edges [Nilsson 2008, eq. 4.2]: f_s = k_s Δl + k_d Δv.
//
// On the first end of edge e, with d = x_second − x_first, l = |d|, and w the velocities:
//   f = (k_s (l − L0) + k_d (w_second − w_first)·d/l) d/l = c_e d,   and −c_e d on the second end.
// With weights w_e (TemplateView::springWeights) c_e is w_e times that. One number c_e per edge; the ring pass
// (ring_kernel.h) adds c_e d at either end, with d from that end to the other.
#include "base/lane_prefetch.h"
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

/// Prefetches a line of each array of the next block's state. A closed mesh of V vertices has 3V − 6 edges, so all
/// lines but two vertices' are prefetched. The latency of roots and quotients hides the cost.
MORULA_INLINE void prefetchNextBlock(const TemplateView& mesh, const BlockView& b, int edge) {
  constexpr int line = blockLanes * sizeof(Real);
  const std::int64_t from = std::int64_t(3 * mesh.vertexCount + edge) * line;
  prefetch<line>(b.position.place, from);
  prefetch<line>(b.velocity.place, from);
  prefetch<line>(b.acceleration.place, from);
}

/// Sets `damping` to k_d of a block's cells, whose vertices have the masses of the moment (damping.h).
MORULA_INLINE void findSpringDamping(const BlockView& b, const KernelParameters& p,
                                     Lanes (&damping)[blockLanes / width]) {
  for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group)
    damping[group] = p.damping + p.dampingPerRoot * sqrt(load(b.vertexMass + lane));
}

template <bool damped, bool weighted>
inline void findTensions(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const Lanes stiffness = p.stiffness;
  Real* coefficient = b.coefficient;
  Lanes damping[blockLanes / width];
  if constexpr (damped) findSpringDamping(b, p, damping);
  for (int e = 0; e < mesh.edgeCount; ++e) {
    const int first = mesh.edges[2 * e], second = mesh.edges[2 * e + 1];
    const Lanes templateLength = mesh.restLengths[e];
    prefetchNextBlock(mesh, b, e);
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Vec d = loadVec(b.position, second, lane) - loadVec(b.position, first, lane);
      const Lanes length = sqrt(dot(d, d) + tiny);
      const Lanes inverse = 1.0 / length;
      Lanes tension = stiffness * (length - templateLength * load(b.restScale + lane));
      if constexpr (damped) {
        const Vec dw = loadVec(b.predicted, second, lane) - loadVec(b.predicted, first, lane);
        tension += damping[group] * (dot(dw, d) * inverse);
      }
      if constexpr (weighted) tension = Lanes(mesh.springWeights[e]) * tension;
      store(coefficient + e * blockLanes + lane, tension * inverse);
    }
  }
}

}  // namespace morula::MORULA_ISA

#pragma once
// One-ring accumulation: one pass over the ring of neighbours of each vertex gives its spring force, its share of
// the volume's gradient, and the volume. No pass over faces, no scatter.
//
//   d_k = x_k − x                    to neighbour k, counter-clockwise seen from outside
//   F   = Σ c_k d_k                  springs; c_k of the edge (spring_kernel.h)
//   G   = Σ d_k × d_{k+1} = 6 ∇V     each face of the ring adds twice its area vector, and ∇V a third of an area.
//                                    For an even ring Σ over odd k of d_k × (x_{k+1} − x_{k−1}): half the products
//   V   = Σ_i G_i·(x_i − x_0) / 18   V is homogeneous of third degree: Σ ∇_iV·x_i = 3V, and 6·3 = 18. It equals
//                                    [Nilsson 2008, eq. 4.4]. Any x_0 serves; a vertex of the cell keeps the
//                                    terms small
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

// Wide lanes come with registers enough for the whole ring; elsewhere compilers would keep half of it in memory.
constexpr int unrolled = width == 8 ? 3 : 1;

template <bool springs>
MORULA_INLINE void accumulateRing(const Real* __restrict position, const Real* __restrict coefficient,
                                  const RingStep* ring, int steps, const Vec& x, Vec& force, Vec& gradient) {
  force = gradient = {Lanes(0.0), Lanes(0.0), Lanes(0.0)};
#pragma GCC unroll unrolled
  for (int k = 0; k < steps; k += 2) {
    const Real* even = position + ring[k].vertexOffset;
    const Real* next = position + ring[k + 2 < steps ? k + 2 : 0].vertexOffset;
    if constexpr (springs) force += load(coefficient + ring[k].edgeOffset) * (loadVec(even) - x);
    const Vec odd = loadVec(position + ring[k + 1].vertexOffset) - x;
    if constexpr (springs) force += load(coefficient + ring[k + 1].edgeOffset) * odd;
    gradient += cross(odd, loadVec(next) - loadVec(even));
  }
}

/// acceleration ← spring force, or 0 without springs; gradient ← 6∇V, volume ← V.
template <bool springs>
inline void accumulateRings(const TemplateView& mesh, const BlockView& b, const KernelParameters&) {
  const Real* __restrict position = b.position;
  const Real* __restrict coefficient = b.coefficient;
  Real* __restrict forces = b.acceleration;
  Real* __restrict gradients = b.gradient;
  const int liveLanes = b.liveLanes;
  Lanes volume[blockLanes / width];
  for (Lanes& v : volume) v = Lanes(0.0);
  for (int v = 0; v < mesh.vertexCount; ++v) {
    const RingStep* ring = mesh.ring + mesh.ringStart[v];
    const int steps = mesh.ringStart[v + 1] - mesh.ringStart[v];
    for (int lane = 0, group = 0; lane < liveLanes; lane += width, ++group) {
      const Vec x = loadVec(position, v, lane);
      Vec force, gradient;
      if (steps == 6) accumulateRing<springs>(position + lane, coefficient + lane, ring, 6, x, force, gradient);
      else accumulateRing<springs>(position + lane, coefficient + lane, ring, steps, x, force, gradient);
      storeVec(forces, v, lane, force);
      storeVec(gradients, v, lane, gradient);
      volume[group] += dot(gradient, x - loadVec(position, 0, lane));
    }
  }
  for (int lane = 0, group = 0; lane < liveLanes; lane += width, ++group) store(b.volume + lane, volume[group] / 18.0);
}

}  // namespace morula::MORULA_ISA

#pragma once
// Bending of the membrane: Helfrich's energy ½ κ ∫ (2H)² dA [Helfrich 1973], with the mean curvature of a mesh by
// cotangents [Pinkall & Polthier 1993; Bergou et al. 2006].
//
//   L_v = Σ_k w_k (x_k − x_v)     sum over the one-ring; w = (cot α + cot β)/2 of the edge at rest, so L = 2H a n
//   c_v = L_v/a_v                 a_v: a third of the areas of the faces around v at rest, times the cell's scale²
//   E   = ½ κ Σ_v L_v·c_v                                                                                    [energy]
//   F_v = κ Σ_k w_k (c_v − c_k)   −∂E/∂x_v exactly: w is alike from both ends of an edge
//
// Angles and areas are those at rest, so E is quadratic and F linear in the positions: there is no fold at which a force
// jumps or vanishes, and one number bounds the stiffness (MeshTemplate::Bending). Areas that are stretched by λ² in all
// directions raise E by λ², so bending adds 2κ/r² to the tension of a sphere.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

/// acceleration += F. Uses the scratch `curvature` for c.
inline void addBendingForces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const Real* position = b.position;
  Real* curvature = b.curvature;
  for (int v = 0; v < mesh.vertexCount; ++v) {
    const int begin = mesh.ringStart[v], end = mesh.ringStart[v + 1];
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane);
      Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      for (int k = begin; k < end; ++k)
        sum += Lanes(mesh.bendingWeights[k]) * (loadVec(position + mesh.ring[k].vertexOffset + lane) - x);
      storeVec(b.curvature, v, lane, Lanes(mesh.inverseAreas[v]) * sum);
    }
  }
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Lanes scale = load(b.restScale + lane), rigidity = p.bending / (scale * scale);
    for (int v = 0; v < mesh.vertexCount; ++v) {
      const Vec own = loadVec(b.curvature, v, lane);
      Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      for (int k = mesh.ringStart[v]; k < mesh.ringStart[v + 1]; ++k)
        sum += Lanes(mesh.bendingWeights[k]) * (own - loadVec(curvature + mesh.ring[k].vertexOffset + lane));
      storeVec(b.acceleration, v, lane, loadVec(b.acceleration, v, lane) + rigidity * sum);
    }
  }
}

}  // namespace morula::MORULA_ISA

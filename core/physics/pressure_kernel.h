#pragma once
// Inner pressure [Nilsson 2008, eq. 4.3, 4.5]: P = k_p/V − P_0, and on a vertex f = P Σ A_F/3 = P ∇V = P G/6.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

/// The forces of the fluids that a block's cells enclose, with the medium's drag if `dragged`. Sets pressure ← P.
template <bool dragged>
struct EnclosedFluid {
  MORULA_INLINE EnclosedFluid(const BlockView& b, const KernelParameters& p)
      : forces(b.acceleration), gradients(b.gradient), predicted(b.predicted) {
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      const Lanes pressure = load(b.pressureConstant + lane) / load(b.volume + lane) - p.outsidePressure;
      store(b.pressure + lane, pressure);
      sixth[group] = pressure / 6.0;
      if constexpr (dragged) resistance[group] = p.drag * load(b.vertexMass + lane);
    }
  }

  /// Returns the spring force plus P∇V and, if `dragged`, −drag·m·w, which is in proportion to mass.
  MORULA_INLINE Vec forceWith(int v, int lane, int group) const {
    Vec force = loadVec(forces, v, lane) + sixth[group] * loadVec(gradients, v, lane);
    if constexpr (dragged) force -= resistance[group] * loadVec(predicted, v, lane);
    return force;
  }

  const Real *forces, *gradients, *predicted;
  Lanes sixth[blockLanes / width], resistance[blockLanes / width];
};

template <bool dragged>
inline void addPressureForces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  const EnclosedFluid<dragged> fluid(b, p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group)
      storeVec(b.acceleration, v, lane, fluid.forceWith(v, lane, group));
}

/// Sets only pressure ← P, where the drift has solved for its forces (xpbd_kernel.h).
inline void findPressure(const TemplateView&, const BlockView& b, const KernelParameters& p) {
  for (int lane = 0; lane < b.liveLanes; lane += width)
    store(b.pressure + lane, load(b.pressureConstant + lane) / load(b.volume + lane) - p.outsidePressure);
}

}  // namespace morula::MORULA_ISA

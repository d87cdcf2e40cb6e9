#pragma once
// Inner pressure [Nilsson 2008, eq. 4.3, 4.5]: P = k_p/V − P_0, and on a vertex f = P Σ A_F/3 = P ∇V = P G/6.
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

/// force += P∇V, and with drag −drag·m·w: the medium's resistance in proportion to mass. pressure ← P.
template <bool dragged>
inline void addPressureForces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  Lanes sixth[blockLanes / width], resistance[blockLanes / width];
  for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
    const Lanes pressure = load(b.pressureConstant + lane) / load(b.volume + lane) - p.outsidePressure;
    store(b.pressure + lane, pressure);
    sixth[group] = pressure / 6.0;
    if constexpr (dragged) resistance[group] = p.drag * load(b.vertexMass + lane);
  }
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      Vec force = loadVec(b.acceleration, v, lane) + sixth[group] * loadVec(b.gradient, v, lane);
      if constexpr (dragged) force -= resistance[group] * loadVec(b.predicted, v, lane);
      storeVec(b.acceleration, v, lane, force);
    }
}

/// pressure ← P alone, where another stage moves the contents.
inline void findPressure(const TemplateView&, const BlockView& b, const KernelParameters& p) {
  for (int lane = 0; lane < b.liveLanes; lane += width)
    store(b.pressure + lane, load(b.pressureConstant + lane) / load(b.volume + lane) - p.outsidePressure);
}

}  // namespace morula::MORULA_ISA

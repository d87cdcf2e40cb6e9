#pragma once
// Loading and storing the three lines of a vertex, for the kernels.
#include "base/lanes.h"
#include "base/vec3.h"
#include "physics/block.h"

namespace morula::MORULA_ISA {

using Vec = Vec3<Lanes>;

/// Loads the vectors of `width` cells, from the lane that `p` points to on.
MORULA_INLINE Vec loadVec(const Real* p) { return {load(p), load(p + blockLanes), load(p + 2 * blockLanes)}; }

/// Loads vertex `v` of a [vertex][3][lane] array, from lane `lane` on.
MORULA_INLINE Vec loadVec(const Real* array, int v, int lane) { return loadVec(array + v * vertexStride + lane); }

MORULA_INLINE void storeVec(Real* array, int v, int lane, const Vec& a) {
  Real* p = array + v * vertexStride + lane;
  store(p, a.x);
  store(p + blockLanes, a.y);
  store(p + 2 * blockLanes, a.z);
}

}  // namespace morula::MORULA_ISA

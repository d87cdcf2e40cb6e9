#pragma once
// The measures of surfaces that cut through themselves, as cells are measured with them.
#include "mesh/mesh.h"
#include "mesh/mesh_measures.h"
#include "mesh/overlap.h"

namespace morula {

inline double selfOverlapOf(const Mesh& m, int columns = 24) {
  return measureSelfOverlap({m.vertices, m.faces}, columns);
}

inline bool isStarShaped(const Mesh& m) { return isStarShaped({m.vertices, m.faces}, measureCentroid(m.vertices)); }

}  // namespace morula

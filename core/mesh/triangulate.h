#pragma once
// A polygon with corners in space, cut into triangles.
#include <array>
#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace morula {

struct Triangulation {
  std::vector<std::array<int, 3>> triangles;  // corners' numbers; they turn as the polygon does
  std::string wrong;                          // says why the polygon has no triangles; empty if it has
};

/// Cuts a polygon of three or more corners into triangles that cover it once. The polygon may be concave, a corner may
/// lie on the line between its neighbours, and corners may lie a little off one plane. The triangles are the fan around
/// corner 0 where that fan covers the polygon; otherwise ears are cut off [Meisters 1975], at each step the ear whose
/// smallest height over its longest side is the largest.
///
/// A polygon that crosses itself, or that has no area, has no triangles.
Triangulation triangulate(const std::vector<Point>& corners);

}  // namespace morula

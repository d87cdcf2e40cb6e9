#pragma once
// How far two surfaces are apart.
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// [length] From each vertex of one surface to the nearest point of the other.
std::vector<double> measureDistances(const Mesh& from, const Mesh& to);

/// [length] From the vertices of either surface to the nearest points of the other: the root mean square of
/// all. Meshes may differ. 0 for the same surface.
double measureSurfaceDistance(const Mesh& a, const Mesh& b);

/// [length] How far below the surface of the closed mesh `b` the deepest vertex of `a` lies; 0 where none is inside.
double measureDepth(const Mesh& a, const Mesh& b);

}  // namespace morula

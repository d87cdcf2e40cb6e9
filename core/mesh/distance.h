#pragma once
// Distances between two surfaces.
#include <vector>

#include "mesh/mesh.h"

namespace morula {

/// Returns the distance [length] from each vertex of `from` to the nearest point of the surface of `to`.
std::vector<double> measureDistances(const Mesh& from, const Mesh& to);

/// Returns the root mean square distance [length] from the vertices of each surface to the nearest points of the other.
/// The meshes may differ. 0 for the same surface.
double measureSurfaceDistance(const Mesh& a, const Mesh& b);

/// Returns the depth [length] of `a`'s deepest vertex below the surface of the closed mesh `b`; 0 if none is inside.
double measureDepth(const Mesh& a, const Mesh& b);

}  // namespace morula

#pragma once
// Plane sections of a closed mesh, and the smallest of them.
#include "mesh/mesh.h"

namespace morula {

/// [length²] Of the plane section with that unit normal through a point: the area that a closed mesh encloses
/// in it, exactly, through faces. Holes count as such.
double sectionArea(const Mesh& mesh, const Point& point, const Vector& normal);

/// The unit normal of the plane through a point whose section of the mesh has the least area, to 1e-5 rad where the
/// minimum is not flat. Searched on the 321 directions of a fine icosphere (one of each two opposite ones), and from
/// each local minimum among these that is at most 2 % larger than the least one in ever smaller steps. Of sections that
/// are equally small to 1e-6, as those of a symmetric shape, it is the one whose normal lies nearest to (1, 0.55, 0.2),
/// a direction to which no symmetric shape lies at right angles, and it points to its side.
Vector smallestSection(const Mesh& mesh, const Point& point);

}  // namespace morula

#pragma once
// Plane sections of a closed mesh, and the smallest of them.
#include "mesh/mesh.h"

namespace morula {

/// Returns the area [length²] that a closed mesh encloses in the plane with this unit normal through a point, exactly,
/// through faces. Holes count as such.
double sectionArea(const Mesh& mesh, const Point& point, const Vector& normal);

/// Returns the unit normal of the plane through a point whose section of the mesh has the least area, to 1e-5 rad where
/// the minimum is not flat. Searches the 321 directions of a fine icosphere (one of each two opposite ones), and from
/// each local minimum at most 2 % above the least one goes on in ever smaller steps. Of sections equally small to 1e-6,
/// as those of a symmetric shape, it takes the one whose normal is nearest to (1, 0.55, 0.2), a direction to which no
/// symmetric shape lies at right angles. The normal points to the side of this direction.
Vector smallestSection(const Mesh& mesh, const Point& point);

}  // namespace morula

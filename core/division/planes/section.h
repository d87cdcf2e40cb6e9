#pragma once
// Plane sections of a closed mesh, and the smallest of them.
#include "mesh/mesh.h"

namespace morula {

/// Returns the area [length²] in which a plane through `point`, with this unit normal, cuts a closed mesh. The area is
/// exact, since the plane may cut through faces. Holes in the section are left out.
double sectionArea(const Mesh& mesh, const Point& point, const Vector& normal);

/// Returns the unit normal of the plane through `point` that cuts the mesh with the min area (sectionArea). The normal
/// is accurate to 1e-5 rad where the minimum is not flat.
///
/// Searches the 321 directions of half a fine icosphere. Then refines, in ever smaller steps, each local minimum that
/// is at most 2 % above the smallest one. Sections of a symmetric shape can be equally small to 1e-6. Of these, takes
/// the one whose normal is nearest to (1, 0.55, 0.2), a direction that is perpendicular to no axis of usual shapes. The
/// normal points to the side of this direction.
Vector smallestSection(const Mesh& mesh, const Point& point);

}  // namespace morula

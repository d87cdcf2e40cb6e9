#pragma once
// Measures the share of closed meshes' volume that lies in more than one of them.
#include <functional>
#include <span>
#include <vector>

#include "mesh/mesh_measures.h"

namespace morula {

struct MeshView {
  Points vertices;
  Faces faces;
};

/// Returns the smallest box along the axes that holds all meshes. Requires at least one mesh.
Box boxAround(std::span<const MeshView> meshes);

struct Overlap {
  std::vector<double> volumes;  // [length³] per mesh, as the scan lines see it
  std::vector<double> shares;   // per mesh: the share of its volume that lies in another mesh too [1]
  // Per mesh: of the space that it winds around, the share it winds around more than once, or inside out. 0 for a
  // surface that does not cut through itself. [1]
  std::vector<double> selfShares;
  double unionVolume = 0;    // [length³] of all meshes together, each place counted once
  double meanShare() const;  // over the meshes; 0 if there are none [1]
};

/// Cuts closed meshes by `columns` × `columns` vertical lines over the box that holds them all. The result is exact
/// along the lines, and by the midpoint rule across them: the error falls a little faster than 1/columns. A place is in
/// a mesh that winds around it (inverted parts are nowhere). A mesh that no line meets has volume and share 0. Cost:
/// triangles × lines through each, plus sorting the crossings of each line.
Overlap measureOverlap(std::span<const MeshView> meshes, int columns = 256);

/// Uses vertical lines `spacing` apart, the first at half of it from `low`: calls visit(column, row, from, to) for each
/// stretch [from, to) along z that lies in a mesh, row by row and upwards. Stretches of several meshes may meet.
void visitInside(std::span<const MeshView> meshes, const Point& low, double spacing, int columns, int rows,
                 const std::function<void(int, int, double, double)>& visit);

/// Returns the volume [length³] that two closed meshes share, by lines only where both boxes are. Boxes that do not
/// meet give 0 at no cost.
double measureSharedVolume(const MeshView& a, const MeshView& b, int columns);

/// Measures Overlap::selfShares [1] of one closed mesh by `columns` × `columns` lines along each of the three axes. A
/// thin lens that lines along one axis miss is seen along another.
double measureSelfOverlap(const MeshView& mesh, int columns);

/// True only if the closed mesh is star-shaped about the point, which must not lie on the surface: each ray from the
/// point meets the surface once, so it cannot cut through itself. Cost: each face twice, far less than scan lines.
bool isStarShaped(const MeshView& mesh, const Point& centre);

}  // namespace morula

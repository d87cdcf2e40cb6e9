#pragma once
// How much of the volume of closed meshes lies in more than one of them.
#include <functional>
#include <span>
#include <vector>

#include "mesh/measures.h"

namespace morula {

struct MeshView {
  Points vertices;
  Faces faces;
};

/// The smallest box along the axes that holds them all. There must be one at least.
Box boxAround(std::span<const MeshView> meshes);

struct Overlap {
  std::vector<double> volumes;  // [length³] per mesh, as the scan lines see it
  std::vector<double> shares;   // per mesh: the share of its volume that lies in another mesh too [1]
  // Per mesh: the share of what it winds around that it winds around more than once, or inside out. 0 of a surface
  // that does not cut through itself. [1]
  std::vector<double> selfShares;
  double unionVolume = 0;    // [length³] of all meshes together, each place counted once
  double meanShare() const;  // over the meshes; 0 if there are none [1]
};

/// Cuts closed meshes by `columns` × `columns` vertical lines over the box that holds them all; exact along
/// the lines, midpoint rule across them: the error falls a little faster than 1/columns. A place is in a mesh
/// that winds around it (inverted parts are nowhere). A mesh that no line meets has volume and share 0.
/// Cost: triangles × lines through each, plus sorting the crossings of each line.
Overlap measureOverlap(std::span<const MeshView> meshes, int columns = 256);

/// Uses vertical lines `spacing` apart, the first at half of it from `low`: calls visit(column, row, from, to) for each
/// stretch [from, to) along z that lies in a mesh, row by row and upwards. Stretches of several meshes may meet.
void visitInside(std::span<const MeshView> meshes, const Point& low, double spacing, int columns, int rows,
                 const std::function<void(int, int, double, double)>& visit);

/// [length³] What two closed meshes have in common: the same with lines only where both boxes are. 0 at no
/// cost where the boxes do not meet.
double measureSharedVolume(const MeshView& a, const MeshView& b, int columns);

/// [1] Overlap::selfShares of one closed mesh, by `columns` × `columns` lines along each of the three axes: a thin lens
/// that lines along one axis pass by is seen along another.
double measureSelfOverlap(const MeshView& mesh, int columns);

/// True only if the closed mesh is star-shaped about the point, which must not lie on it: each ray from there meets the
/// surface once, so that it cannot cut through itself. Cost: each face twice, far less than a measurement by lines.
bool isStarShaped(const MeshView& mesh, const Point& centre);

}  // namespace morula

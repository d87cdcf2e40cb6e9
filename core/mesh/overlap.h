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
  double unionVolume = 0;       // [length³] of all meshes together, each place counted once
  double meanShare() const;     // over the meshes; 0 if there are none [1]
};

/// Cuts closed meshes by `columns` × `columns` vertical lines over the box that holds them all; exact along
/// the lines, midpoint rule across them: the error falls a little faster than 1/columns. A place is in a mesh
/// that winds around it (inverted parts are nowhere). A mesh that no line meets has volume and share 0.
/// Cost: triangles × lines through each, plus sorting the crossings of each line.
Overlap measureOverlap(std::span<const MeshView> meshes, int columns = 256);

/// The same lines, `spacing` apart, the first at half of it from `low`: calls visit(column, row, from, to) for each stretch
/// [from, to) along z that lies in a mesh, row by row and upwards. Stretches of several meshes may meet.
void visitInside(std::span<const MeshView> meshes, const Point& low, double spacing, int columns, int rows,
                 const std::function<void(int, int, double, double)>& visit);

/// [length³] What two closed meshes have in common: the same with lines only where both boxes are. 0 at no
/// cost where the boxes do not meet.
double measureSharedVolume(const MeshView& a, const MeshView& b, int columns);

}  // namespace morula

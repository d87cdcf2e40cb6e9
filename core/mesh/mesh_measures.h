#pragma once
// Measures of one closed triangle mesh. Pure functions; sums run in the order of the faces, so their
// bits are the same everywhere. Lengths are in the scene's unit.
#include <span>

#include "mesh/mesh.h"

namespace morula {

using Points = std::span<const Point>;
using Faces = std::span<const Face>;

/// Returns the volume [length³] by the divergence theorem [Nilsson 2008, eq. 4.4, appendix A]; negative if inverted.
double measureVolume(Points vertices, Faces faces);

/// Returns the mesh scaled about the origin to enclose this volume [length³]. The mesh must have a positive volume.
Mesh scaleToVolume(Mesh mesh, double volume);

/// Scales a mesh to the volume of a sphere of this radius [length]. An inscribed icosphere encloses less than
/// its sphere (97 % with 162 vertices), so its vertices come to lie a little farther out than the radius.
Mesh scaleToRadius(Mesh mesh, double radius);

/// [length²]
double measureArea(Points vertices, Faces faces);

/// Returns the mean [length] of the vertices, which carry the mass: the thesis' centre of mass, not the volume's.
Point measureCentroid(Points vertices);

/// Moments of the solid of even density that a closed surface encloses.
struct SolidMoments {
  double volume = 0;  // [length³]
  Point centre;       // [length] of the volume, not of the vertices
  double second = 0;  // [length⁵] ∫ |x − centre|² dV; of a ball 3/5 V r²
};
SolidMoments measureMoments(Points vertices, Faces faces);

/// π^(1/3) (6V)^(2/3) / A: the area of the sphere with volume V over A. 1 for a sphere, 0.806 for a cube,
/// 0 if there is no volume. [1]
double sphericity(double volume, double area);

struct Box {
  Point low, high;
};

/// Returns the smallest box along the axes that holds the vertices. Requires at least one vertex.
Box measureBox(Points vertices);

}  // namespace morula

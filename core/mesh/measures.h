#pragma once
// Measures of one closed triangle mesh. Pure functions; sums run in the order of the faces, so their
// bits are the same everywhere. Lengths are in the scene's unit.
#include <span>

#include "mesh/mesh.h"

namespace morula {

using Points = std::span<const Point>;
using Faces = std::span<const Face>;

/// [length³] by the divergence theorem [Nilsson 2008, eq. 4.4, appendix A]; negative if the faces are
/// inverted.
double measureVolume(Points vertices, Faces faces);

/// The mesh, scaled about the origin, that encloses this volume [length³]. Its own must be positive.
Mesh scaleToVolume(Mesh mesh, double volume);

/// The same with the volume of a sphere of this radius [length]. An inscribed icosphere encloses less than
/// its sphere (97 % with 162 vertices), so its vertices come to lie a little farther out than the radius.
Mesh scaleToRadius(Mesh mesh, double radius);

/// [length²]
double measureArea(Points vertices, Faces faces);

/// [length] The mean of the vertices, which carry the mass: the thesis' centre of mass, not the volume's.
Point measureCentroid(Points vertices);

/// π^(1/3) (6V)^(2/3) / A: the area of the sphere with volume V over A. 1 for a sphere, 0.806 for a cube,
/// 0 if there is no volume. [1]
double sphericity(double volume, double area);

struct Box {
  Point low, high;
};

/// The smallest box along the axes that holds the vertices. There must be one at least.
Box measureBox(Points vertices);

/// How far the triangles are from equal and equilateral, which the springs and the contact radius assume.
struct Quality {
  double shortestEdge = 0, longestEdge = 0;  // [length]
  // Cosines, for angles would need a function whose bits differ between machines. An equilateral triangle has
  // 0.5.
  double sharpestCosine = 0;  // of the smallest angle of all faces: towards 1 for a needle [1]
  double bluntestCosine = 0;  // of the largest angle: towards −1 for a cap [1]
};
Quality measureQuality(Points vertices, Faces faces);

/// The number of faces whose inner side is not turned to `centre`: 0 for a mesh that is star-shaped about it,
/// as every convex one is about any point inside. A convex cell that comes to have many is turning inside out.
int countFacesTurnedInward(Points vertices, Faces faces, const Point& centre);

/// True if the closed mesh winds around the point, from the crossings of the half line upwards (+z) from it.
/// A point on the surface counts as inside or outside, but as one of them: of meshes that tile space exactly
/// one has it.
bool isInside(const Point& point, Points vertices, Faces faces);

}  // namespace morula

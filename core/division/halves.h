#pragma once
// Both sides of a plane.
#include <vector>

#include "mesh/measures.h"

namespace morula {

/// What a plane makes of a closed surface: a copy of it for each side, in which the vertices beyond the plane
/// lie on it. Connectivity stays.
struct Halves {
  std::vector<Point> a, b;  // a on the side that the normal points to
  double volumeA, volumeB;  // [length³]
};

/// Projects the vertices beyond the plane along its unit normal, and takes out what that folds over (unfold.h).
/// Where nothing folds, both volumes add up to the whole exactly: a face's shadow on the plane stays the same.
Halves halve(Points vertices, Faces faces, const Point& onPlane, const Vector& normal);

}  // namespace morula

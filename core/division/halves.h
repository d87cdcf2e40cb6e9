#pragma once
// Cuts a surface into halves by projection onto a plane, and unfolds what projection folds over.
//
// A mother that is not convex casts parts of her far side onto one another: faces of the flat side lie upside down.
// Most would spring open by themselves, some would stay as a dent. So the projected vertices are drawn towards the mean
// of their neighbours, within the plane, until no face lies upside down. The fixed point of this is Tutte's embedding,
// which has no fold where the rim is convex [Tutte 1963].
#include <vector>

#include "mesh/mesh_measures.h"

namespace morula {

/// Counts faces between three projected vertices that look the wrong way; `outward`: unit normal of the flat side.
int countFolds(Points vertices, Faces faces, const std::vector<char>& isProjected, const Vector& outward);

/// Moves projected vertices within the plane, only until no face is folded; at most `sweeps` times. Bodies without
/// folds stay as they are. Returns the number of folds left.
int unfold(std::vector<Point>& vertices, Faces faces, const std::vector<char>& isProjected, const Vector& outward,
           int sweeps = 200);

/// The two halves of a closed surface: for each side of the plane a copy, in which the vertices beyond the plane lie on
/// the plane. Connectivity stays.
struct Halves {
  std::vector<Point> a, b;  // a on the side that the normal points to
  double volumeA, volumeB;  // [length³]
};

/// Projects the vertices beyond the plane along its unit normal, once for each side of the plane, and unfolds the
/// results. If nothing folds, both volumes add up to the whole exactly: a face's shadow on the plane stays the same.
Halves halve(Points vertices, Faces faces, const Point& onPlane, const Vector& normal);

}  // namespace morula

#pragma once
// What projection onto the plane folds over, unfolded again.
//
// A mother that is not convex casts parts of her far side onto one another: faces of the flat side that lie
// upside down. Most would spring open by themselves, some would stay as a dent. So the projected vertices are
// drawn towards the mean of their neighbours, within the plane, until no face lies upside down. The fixed
// point of that is Tutte's embedding, which has no fold where the rim is convex [Tutte 1963].
#include <span>
#include <vector>

#include "mesh/measures.h"

namespace morula {

/// The faces between three projected vertices that look the wrong way; `outward` is the unit normal of the flat side.
int countFolds(Points vertices, Faces faces, const std::vector<char>& isProjected, const Vector& outward);

/// Moves projected vertices within the plane, as little as unfolds them all; at most `sweeps` times. Bodies
/// without folds stay as they are. Returns the folds that are left.
int unfold(std::vector<Point>& vertices, Faces faces, const std::vector<char>& isProjected, const Vector& outward,
           int sweeps = 200);

}  // namespace morula

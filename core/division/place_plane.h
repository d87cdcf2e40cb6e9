#pragma once
// Where along its normal a plane cuts off a given share.
#include "mesh/measures.h"

namespace morula {

/// A point of the plane with this unit normal on whose far side, the one that the normal points to, lies this share
/// [1] of what the closed surface encloses, as `halve` will measure it: to 1e-12 where the projection onto the
/// plane folds nothing over. Unfolding moves in jumps as the plane passes vertices; then it is the plane where
/// the share changes from more to less. `share`: above 0 and below 1.
Point placePlane(Points vertices, Faces faces, const Vector& normal, double share);

}  // namespace morula

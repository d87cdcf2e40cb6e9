#pragma once
// Places a plane along its normal so that it cuts off a given share.
#include "mesh/measures.h"

namespace morula {

/// A point of the plane with this unit normal on whose far side, the one that the normal points to, lies this share
/// [1] of what the closed surface encloses, as `halve` will measure it: to 1e-12, but where what projection folds over is
/// unfolded (as it mostly is on the smaller side of an unequal cut) and the share jumps as the plane passes a vertex.
/// Then it is the plane beside the jump, on the side whose share is nearer: off by at most 0.002 for a ball of 162 vertices,
/// 0.03 for one of 42. `share`: above 0 and below 1.
Point placePlane(Points vertices, Faces faces, const Vector& normal, double share);

}  // namespace morula

#pragma once
// Places a plane along its normal so that it cuts off a given share.
#include "mesh/mesh_measures.h"

namespace morula {

/// Returns a point of the plane with this unit normal that has this share [1] of the closed surface's volume on the
/// side that the normal points to. `share`: above 0 and below 1. `halve` will measure the share to 1e-12, except where
/// it unfolds faces (mostly on the smaller side of an unequal cut), so that the share jumps as the plane passes a
/// vertex. The plane then lies beside the jump, on the side whose share is nearer: off by at most 0.002 for a ball of
/// 162 vertices, 0.03 for one of 42.
Point placePlane(Points vertices, Faces faces, const Vector& normal, double share);

}  // namespace morula

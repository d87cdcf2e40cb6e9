#pragma once
// The cut: one body becomes two [Nilsson 2008, §4.4.2, figure 4.7].
//
// The mesh is copied to both daughters, and in each the vertices beyond the plane are projected onto it, so
// connectivity never changes and both volumes add up to the mother's. Velocities are copied, and mass is
// shared by volume, so momentum is kept.
#include <optional>
#include <string>

#include "mesh/mesh_measures.h"
#include "physics/bodies.h"

namespace morula {

/// The place at which a cell is cut. A surface is cut along the plane. A sphere, which has no surface, divides into
/// shares of its volume.
struct Cut {
  Point point;    // [length] on the plane
  Vector normal;  // the plane's unit normal; points to daughter A
  // [1] Daughter A's share of the volume, above 0 and below 1: for a surface, placePlane moves the point for it.
  // Absent: the plane goes through the point, and a sphere divides in halves.
  std::optional<double> share = {};
  std::optional<Vector> polarity = {};  // polarity that both daughters inherit [CellContext::inheritedPolarity]
};

struct Daughters {
  Body a, b;  // a on the side that the normal points to
};

struct CutResult {
  Daughters daughters;
  std::string failure;  // empty: the cut succeeded
};

/// Cuts along the plane. k_p and mass go by the cut's share, for which placePlane has placed the plane, or without a
/// share by volume. `areaFactor` times the mother's rest area of membrane is shared out by volume^(2/3): 2^(1/3) gives
/// the halves of a sphere just the membrane that their rounded shape needs. Fails if a daughter would get less than a
/// tenth of the volume (half a tenth with a share): such a body never was one piece on either side.
CutResult cutBody(const Body& mother, Faces faces, const Cut& cut, double areaFactor);

/// Divides a sphere of this radius into two that share its volume and mass by the cut's share, side by side along the
/// cut's normal. Both lie within the mother's sphere and touch it from inside, so the division itself pushes no other
/// cell. They overlap at first; contact forces part them.
Daughters divideSphere(const Body& mother, double radius, const Cut& cut);

}  // namespace morula

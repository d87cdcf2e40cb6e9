#pragma once
// The cut: one body becomes two [Nilsson 2008, §4.4.2, figure 4.7].
//
// The mesh is copied to both daughters, and in each the vertices beyond the plane are projected onto it, so
// connectivity never changes and both volumes add up to the mother's. Velocities are copied, and mass is
// shared by volume, so momentum is kept.
#include <span>
#include <string>

#include "mesh/measures.h"
#include "physics/bodies.h"

namespace morula {

struct Daughters {
  Body a, b;  // a on the side that the normal points to
};

struct CutResult {
  Daughters daughters;
  std::string failure;  // empty: the cut succeeded
};

/// Cuts across the plane through the mean of the vertices with unit normal `normal`. k_p and mass go by
/// volume. Of the membrane, `production` times the mother's rest area is shared out by volume^(2/3):
/// production 2^(1/3) gives the halves of a sphere just the membrane that their rounded shape needs. Fails if
/// a daughter would get less than a tenth of the volume: such a body never was one piece on either side.
CutResult cutBody(const Body& mother, Faces faces, const Vector& normal, double production);

/// A sphere of that radius becomes two of half its volume and mass within its outline, side by side along
/// `normal`, touching it from inside, so that nobody else is pushed in that moment. They overlap, and contact
/// parts them.
Daughters halveSphere(const Body& mother, double radius, const Vector& normal);

}  // namespace morula

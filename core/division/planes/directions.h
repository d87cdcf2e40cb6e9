#pragma once
// Directions that a cell's shape, contacts and place give to division planes, and the makers of these planes.
#include <optional>
#include <string>
#include <type_traits>

#include "biology/cell_context.h"
#include "biology/physical_unit.h"
#include "division/cut.h"
#include "division/policy.h"

namespace morula {

/// Serves as `make` in the rows of the table of planes: makes a policy from the scenario's choice, from the seed, or
/// from nothing, as the policy needs.
template <class Policy>
std::unique_ptr<DivisionPolicy> makeFromChoice([[maybe_unused]] const PlaneChoice& choice,
                                               [[maybe_unused]] std::uint64_t seed) {
  if constexpr (std::is_constructible_v<Policy, const PlaneChoice&>) return std::make_unique<Policy>(choice);
  else if constexpr (std::is_constructible_v<Policy, std::uint64_t>) return std::make_unique<Policy>(seed);
  else return std::make_unique<Policy>();
}

/// Returns the plane with this unit normal through the centre of mass: it halves a cell that is as large on one side as
/// on the other.
Cut throughCentre(const CellContext& cell, const Vector& normal);

/// Returns the direction of the cell's largest extent [principalAxis], which planes fall back on.
Vector longestExtent(const CellContext& cell);

/// Returns the direction of the cell's largest extent among those at right angles to a unit vector.
Vector longestExtentAcross(const CellContext& cell, const Vector& normal);

/// Returns the unit vector along Σ area · (unit vector to the neighbour's centre), over the neighbours that hold the
/// substance, or one with this beginning before '*'. Absent without such neighbours, or if they lie evenly around the
/// cell: the sum is then less than 1e-6 of the areas, and rounding must not decide.
std::optional<Vector> contactDirection(const CellContext& cell, const std::string& substance);

/// Returns the unit vector from the organism's inside to its outside, at the cell's centre. With a shell: the normal of
/// the ellipsoid of the shell's shape through this point, (x/a², y/b², z/c²), or of a shell mesh's nearest face.
/// Without one: away from the centre of all cells' volume. Absent for a cell within 1 % of its own radius (of the ball
/// of equal volume) from the organism's centre.
std::optional<Vector> outwardDirection(const CellContext& cell);

}  // namespace morula

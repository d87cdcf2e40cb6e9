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

/// The `make` of a row of the table of planes: a policy made from the scenario's choice, or from the seed, or, where it
/// needs neither, from nothing.
template <class Policy>
std::unique_ptr<DivisionPolicy> makeFromChoice([[maybe_unused]] const PlaneChoice& choice,
                                               [[maybe_unused]] std::uint64_t seed) {
  if constexpr (std::is_constructible_v<Policy, const PlaneChoice&>) return std::make_unique<Policy>(choice);
  else if constexpr (std::is_constructible_v<Policy, std::uint64_t>) return std::make_unique<Policy>(seed);
  else return std::make_unique<Policy>();
}

/// The plane with this unit normal through the centre of mass: in halves, as far as the cell is as large on one
/// side of it as on the other.
Cut throughCentre(const CellContext& cell, const Vector& normal);

/// The direction of the cell's largest extent [principalAxis]. What a plane takes that finds nothing to go by.
Vector longestExtent(const CellContext& cell);

/// Returns the direction of the cell's largest extent among those at right angles to a unit vector.
Vector longestExtentAcross(const CellContext& cell, const Vector& normal);

/// The unit vector along Σ area · (unit vector to the neighbour's centre), over the neighbours that hold a
/// substance, or one that fits its beginning and '*'. Absent if there is none, or if they lie evenly around
/// the cell: the sum is then less than 1e-6 of the areas, and rounding must not decide.
std::optional<Vector> contactDirection(const CellContext& cell, const std::string& substance);

/// The unit vector from the inside of the organism to its outside, at the cell's centre: with a shell the normal of the
/// ellipsoid of its shape through this point, (x/a², y/b², z/c²), or of a mesh that of its nearest face; without one
/// away from the centre of all cells' volume. Absent for a cell within 1 % of its own radius (of the ball of equal
/// volume) from the organism's centre.
std::optional<Vector> outwardDirection(const CellContext& cell);

}  // namespace morula

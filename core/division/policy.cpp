#include "division/policy.h"

#include <algorithm>

#include "base/error.h"
#include "base/random.h"
#include "biology/physical_unit.h"
#include "division/principal_axis.h"
#include "division/record.h"

namespace morula {

namespace {

/// In halves, as far as the cell is as large on one side of its centre of mass as on the other.
Cut throughCentre(const CellContext& cell, const Vector& normal) {
  return {cell.physical()->getShape().centre, normal};
}

struct FixedAxis final : DivisionPolicy {
  explicit FixedAxis(const Vector& a) : axis(a / norm(a)) {}
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, axis); }
  Vector axis;
};

/// Cells tend to divide across their longest extent [Hertwig 1884; Nilsson 2008, §1.1].
struct LongestExtent final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    return throughCentre(cell, principalAxis(cell.physical()->getShape().surface.vertices));
  }
};

/// One direction per cell, whatever the order in which cells divide.
struct RandomDirection final : DivisionPolicy {
  explicit RandomDirection(std::uint64_t s) : seed(s) {}
  Cut findCut(const CellContext& cell) const override {
    return throughCentre(cell, randomDirection({seed, cell.path, 0, Purpose::divisionPlane}));
  }
  std::uint64_t seed;
};

/// The new wall meets the one before at right angles [Sachs 1877]: of the directions within the mother's
/// plane, the one of the cell's largest extent. Cells that no division made are cut across the given axis.
struct AlternatingPlane final : DivisionPolicy {
  explicit AlternatingPlane(const Vector& a) : first(a / norm(a)) {}
  Cut findCut(const CellContext& cell) const override {
    const DivisionRecord* mother = cell.motherDivision();
    if (!mother) return throughCentre(cell, first);
    std::vector<Point> within = cell.physical()->getShape().surface.vertices;
    for (Point& x : within) x -= dot(x, mother->axis) * mother->axis;
    return throughCentre(cell, principalAxis(within));
  }
  Vector first;
};

using Made = std::unique_ptr<DivisionPolicy>;
using Given = const PlaneChoice&;

constexpr DivisionPlaneKind kinds[] = {
    {.plane = DivisionPlane::longest,
     .name = "longest",
     .meaning = "the direction of their largest extent",
     .needsShape = true,
     .make = [](Given, std::uint64_t) -> Made { return std::make_unique<LongestExtent>(); }},
    {.plane = DivisionPlane::random,
     .name = "random",
     .meaning = "a random direction",
     .usesSeed = true,
     .make = [](Given, std::uint64_t seed) -> Made { return std::make_unique<RandomDirection>(seed); }},
    {.plane = DivisionPlane::axis,
     .name = "axis",
     .meaning = "one fixed axis, which points to daughter A",
     .takes = Takes::axis,
     .make = [](Given p, std::uint64_t) -> Made { return std::make_unique<FixedAxis>(p.axis); }},
    {.plane = DivisionPlane::alternating,
     .name = "alternating",
     .meaning = "an axis at right angles to their mother's, the one of their largest extent, and at first "
                "the given one",
     .takes = Takes::axis,
     .needsShape = true,
     .make = [](Given p, std::uint64_t) -> Made { return std::make_unique<AlternatingPlane>(p.axis); }},
};

}  // namespace

std::span<const DivisionPlaneKind> divisionPlanes() { return kinds; }

const DivisionPlaneKind& kindOf(DivisionPlane plane) {
  const auto at = std::ranges::find(kinds, plane, &DivisionPlaneKind::plane);
  MORULA_CHECK(at != std::end(kinds), "a division plane without a row");
  return *at;
}

std::unique_ptr<DivisionPolicy> makePlanePolicy(const PlaneChoice& choice, std::uint64_t seed) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  if (kind.takes == Takes::axis && !(norm(choice.axis) > 0))
    throw InputError("division.plane: the axis has no length; give a direction such as [1, 0, 0]");
  return kind.make(choice, seed);
}

std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& p, std::uint64_t seed) {
  return makePlanePolicy(p.otherwise, seed);
}

}  // namespace morula

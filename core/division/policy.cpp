#include "division/policy.h"

#include "base/error.h"
#include "base/random.h"
#include "biology/physical_unit.h"
#include "division/principal_axis.h"

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

}  // namespace

std::unique_ptr<DivisionPolicy> makeDivisionPolicy(const DivisionParameters& p, std::uint64_t seed) {
  switch (p.plane) {
    case DivisionPlane::axis:
      if (!(norm(p.axis) > 0))
        throw InputError("division.plane: the axis has no length; give a direction such as [1, 0, 0]");
      return std::make_unique<FixedAxis>(p.axis);
    case DivisionPlane::longest:
      return std::make_unique<LongestExtent>();
    case DivisionPlane::random:
      return std::make_unique<RandomDirection>(seed);
  }
  CHECK(false, "a plane policy without an implementation");
}

}  // namespace morula

// One direction for all cells that are cut so.
#include "division/planes/directions.h"
#include "division/policy.h"

namespace morula {

namespace {

struct FixedAxis final : DivisionPolicy {
  explicit FixedAxis(const Vector& a) : axis(a / norm(a)) {}
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, axis); }
  Vector axis;
};

}  // namespace

extern const DivisionPlaneKind axisPlane;
const DivisionPlaneKind axisPlane{
    .plane = DivisionPlane::axis,
    .name = "axis",
    .meaning = "one fixed axis, which points to daughter A",
    .takes = Takes::axis,
    .make = [](const PlaneChoice& p, std::uint64_t) -> std::unique_ptr<DivisionPolicy> {
      return std::make_unique<FixedAxis>(p.axis);
    }};

}  // namespace morula

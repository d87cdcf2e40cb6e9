// One direction for all cells that are cut so.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

struct FixedAxis final : DivisionPolicy {
  explicit FixedAxis(const PlaneChoice& p) : axis(p.axis / norm(p.axis)) {}
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, axis); }
  Vector axis;
};

}  // namespace

const DivisionPlaneKind axisPlane{
    .plane = DivisionPlane::axis,
    .name = "axis",
    .meaning = "one fixed axis, which points to daughter A",
    .takes = Takes::axis,
    .make = makeFromChoice<FixedAxis>,
};

}  // namespace morula

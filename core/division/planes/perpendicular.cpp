// The axis stands on the organism's surface: one daughter goes in, and daughter A stays outside.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

struct PerpendicularToSurface final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> out = outwardDirection(cell);
    return throughCentre(cell, out ? *out : longestExtent(cell));
  }
};

}  // namespace

const DivisionPlaneKind perpendicularPlane{
    .plane = DivisionPlane::perpendicular,
    .name = "perpendicular",
    .meaning =
        "the direction that stands on the organism's surface, with daughter A outside (in the middle as longest)",
    .make = makeFromChoice<PerpendicularToSurface>,
};

}  // namespace morula

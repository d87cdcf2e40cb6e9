// Planes by the direction of the organism's surface. Along the surface both daughters stay as far out as their mother,
// and a layer of cells stays one; across it one daughter goes in.
#include "division/planes/directions.h"

namespace morula {
namespace {

/// Cuts across the direction along the surface in which the cell has its largest extent.
struct ParallelToSurface final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> out = outwardDirection(cell);
    return throughCentre(cell, out ? longestExtentAcross(cell, *out) : longestExtent(cell));
  }
};

struct PerpendicularToSurface final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> out = outwardDirection(cell);
    return throughCentre(cell, out ? *out : longestExtent(cell));
  }
};

}  // namespace

const DivisionPlaneKind parallelPlane{
    .plane = DivisionPlane::parallel,
    .name = "parallel",
    .meaning = "the direction of their largest extent along the organism's surface (in the middle as longest)",
    .needsShape = true,
    .make = makeFromChoice<ParallelToSurface>,
};

const DivisionPlaneKind perpendicularPlane{
    .plane = DivisionPlane::perpendicular,
    .name = "perpendicular",
    .meaning =
        "the direction that stands on the organism's surface, with daughter A outside (in the middle as longest)",
    .make = makeFromChoice<PerpendicularToSurface>,
};

}  // namespace morula

// The axis lies along the organism's surface: both daughters stay as far out as their mother, and a layer of cells
// stays one.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

/// Of the directions along the surface, the one of the cell's largest extent.
struct ParallelToSurface final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> out = outwardDirection(cell);
    return throughCentre(cell, out ? longestExtentAcross(cell, *out) : longestExtent(cell));
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

}  // namespace morula

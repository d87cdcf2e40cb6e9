// Division planes by the cell's own shape.
#include "division/planes/directions.h"
#include "division/planes/section.h"

namespace morula {
namespace {

/// Cells tend to divide across their longest extent [Hertwig 1884; Nilsson 2008, §1.1].
struct LongestExtent final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, longestExtent(cell)); }
};

/// The new wall has the least area of all walls through the middle [Errera 1886; Besson & Dumais 2011].
struct SmallestArea final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const BodyShape& shape = cell.physical()->getShape();
    return throughCentre(cell, smallestSection(shape.surface, shape.centre));
  }
};

}  // namespace

const DivisionPlaneKind longestPlane{
    .plane = DivisionPlane::longest,
    .name = "longest",
    .meaning = "the direction of their largest extent",
    .needsShape = true,
    .make = makeFromChoice<LongestExtent>,
};

const DivisionPlaneKind smallestAreaPlane{
    .plane = DivisionPlane::smallestArea,
    .name = "smallest-area",
    .meaning = "the direction across which the wall between their daughters has the least area",
    .needsShape = true,
    .make = makeFromChoice<SmallestArea>,
};

}  // namespace morula

// The new wall has the least area of all that pass through the middle [Errera 1886; Besson & Dumais 2011].
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"
#include "division/planes/section.h"

namespace morula {
namespace {

struct SmallestArea final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override {
    const BodyShape& shape = cell.physical()->getShape();
    return throughCentre(cell, smallestSection(shape.surface, shape.centre));
  }
};

}  // namespace

const DivisionPlaneKind smallestAreaPlane{
    .plane = DivisionPlane::smallestArea,
    .name = "smallest-area",
    .meaning = "the direction across which the wall between their daughters has the least area",
    .needsShape = true,
    .make = makeFromChoice<SmallestArea>,
};

}  // namespace morula

// Cells tend to divide across their longest extent [Hertwig 1884; Nilsson 2008, §1.1].
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

struct LongestExtent final : DivisionPolicy {
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, longestExtent(cell)); }
};

}  // namespace

const DivisionPlaneKind longestPlane{
    .plane = DivisionPlane::longest,
    .name = "longest",
    .meaning = "the direction of their largest extent",
    .needsShape = true,
    .make = makeFromChoice<LongestExtent>,
};

}  // namespace morula

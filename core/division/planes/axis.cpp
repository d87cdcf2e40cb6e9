// Division planes by a given axis.
#include "division/division_record.h"
#include "division/planes/directions.h"

namespace morula {
namespace {

/// Cuts all cells across one direction.
struct FixedAxis final : DivisionPolicy {
  explicit FixedAxis(const PlaneChoice& p) : axis(p.axis / norm(p.axis)) {}
  Cut findCut(const CellContext& cell) const override { return throughCentre(cell, axis); }
  Vector axis;
};

/// The new wall meets the mother's wall at right angles [Sachs 1877]: its axis is the direction of the cell's largest
/// extent within the mother's plane. Cells that no division made are cut across the given axis.
struct AlternatingPlane final : DivisionPolicy {
  explicit AlternatingPlane(const PlaneChoice& p) : first(p.axis / norm(p.axis)) {}
  Cut findCut(const CellContext& cell) const override {
    const DivisionRecord* mother = cell.motherDivision();
    return throughCentre(cell, mother ? longestExtentAcross(cell, mother->axis) : first);
  }
  Vector first;
};

}  // namespace

const DivisionPlaneKind axisPlane{
    .plane = DivisionPlane::axis,
    .name = "axis",
    .meaning = "one fixed axis, which points to daughter A",
    .takes = Takes::axis,
    .make = makeFromChoice<FixedAxis>,
};

const DivisionPlaneKind alternatingPlane{
    .plane = DivisionPlane::alternating,
    .name = "alternating",
    .meaning = "an axis at right angles to their mother's, the one of their largest extent, and at first the given one",
    .takes = Takes::axis,
    .needsShape = true,
    .make = makeFromChoice<AlternatingPlane>,
};

}  // namespace morula

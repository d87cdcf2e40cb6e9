// The plane cuts the contact in two, so both daughters keep a part of it, as skin cells do that stay on what
// they cover.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

/// The axis lies in the contact's plane: of those directions the one of the cell's largest extent.
struct AcrossContact final : DivisionPolicy {
  explicit AcrossContact(const PlaneChoice& p) : substance(p.substance) {}
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> contact = contactDirection(cell, substance);
    return throughCentre(cell, contact ? longestExtentAcross(cell, *contact) : longestExtent(cell));
  }
  std::string substance;
};

}  // namespace

const DivisionPlaneKind acrossPlane{
    .plane = DivisionPlane::across,
    .name = "across",
    .meaning = "the direction of their largest extent along such a contact, so that the plane cuts it in two",
    .takes = Takes::substance,
    .needsShape = true,
    .needsContact = true,
    .make = makeFromChoice<AcrossContact>,
};

}  // namespace morula

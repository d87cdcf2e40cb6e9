// Planes by a cell's contact with cells that hold a substance; cells without such a contact divide as by longest.
#include "division/planes/directions.h"

namespace morula {
namespace {

/// `axisFrom` computes the axis from the cell and the direction to its contact.
template <auto axisFrom>
struct ByContact final : DivisionPolicy {
  explicit ByContact(const PlaneChoice& p) : substance(p.substance) {}
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> contact = contactDirection(cell, substance);
    return throughCentre(cell, contact ? axisFrom(cell, *contact) : longestExtent(cell));
  }
  std::string substance;
};

Vector towardsContact(const CellContext&, const Vector& contact) { return contact; }
Vector awayFromContact(const CellContext&, const Vector& contact) { return -contact; }

}  // namespace

/// Daughter A lies at the contact: so the spindle of the worm's P2 turns to EMS, and the spindle of EMS to P2.
const DivisionPlaneKind towardsPlane{
    .plane = DivisionPlane::towards,
    .name = "towards",
    .meaning =
        "the direction to their contact with cells that hold a substance, where daughter A lies (without one "
        "as longest)",
    .takes = Takes::substance,
    .needsContact = true,
    .make = makeFromChoice<ByContact<towardsContact>>,
};

const DivisionPlaneKind awayFromPlane{
    .plane = DivisionPlane::awayFrom,
    .name = "away-from",
    .meaning = "the same direction with daughter B at the contact",
    .takes = Takes::substance,
    .needsContact = true,
    .make = makeFromChoice<ByContact<awayFromContact>>,
};

/// The axis lies in the contact's plane, which the division cuts in two: both daughters keep a part of the contact,
/// like skin cells, which stay on what they cover.
const DivisionPlaneKind acrossPlane{
    .plane = DivisionPlane::across,
    .name = "across",
    .meaning = "the direction of their largest extent along such a contact, so that the plane cuts it in two",
    .takes = Takes::substance,
    .needsShape = true,
    .needsContact = true,
    .make = makeFromChoice<ByContact<longestExtentAcross>>,
};

}  // namespace morula

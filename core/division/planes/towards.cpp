// Daughter A at the contact: as the spindle of the worm's P2 turns to EMS, and that of EMS to P2.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

struct TowardsContact final : DivisionPolicy {
  explicit TowardsContact(const PlaneChoice& p) : substance(p.substance) {}
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> contact = contactDirection(cell, substance);
    return throughCentre(cell, contact ? *contact : longestExtent(cell));
  }
  std::string substance;
};

}  // namespace

const DivisionPlaneKind towardsPlane{
    .plane = DivisionPlane::towards,
    .name = "towards",
    .meaning =
        "the direction to their contact with cells that hold a substance, where daughter A lies (without one "
        "as longest)",
    .takes = Takes::substance,
    .needsContact = true,
    .make = makeFromChoice<TowardsContact>,
};

}  // namespace morula

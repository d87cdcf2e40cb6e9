// Daughter B at the contact, and A away from it.
#include "division/planes/directions.h"
#include "division/planes/make_from_choice.h"

namespace morula {
namespace {

struct AwayFromContact final : DivisionPolicy {
  explicit AwayFromContact(const PlaneChoice& p) : substance(p.substance) {}
  Cut findCut(const CellContext& cell) const override {
    const std::optional<Vector> contact = contactDirection(cell, substance);
    return throughCentre(cell, contact ? -*contact : longestExtent(cell));
  }
  std::string substance;
};

}  // namespace

const DivisionPlaneKind awayFromPlane{
    .plane = DivisionPlane::awayFrom,
    .name = "away-from",
    .meaning = "the same direction with daughter B at the contact",
    .takes = Takes::substance,
    .needsContact = true,
    .make = makeFromChoice<AwayFromContact>,
};

}  // namespace morula

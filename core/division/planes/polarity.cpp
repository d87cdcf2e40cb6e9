// A direction that cells have, keep, and hand on: the egg's is given, daughters inherit their mother's. With a
// substance, a cell that is about to divide and touches a cell that holds the substance takes the direction to that
// contact (or away from it), and its daughters inherit the new direction. So the worm's P lineage turns its polarity
// round at P2, where P2 meets EMS.
#include "division/planes/directions.h"

namespace morula {
namespace {

struct Polarity final : DivisionPolicy {
  explicit Polarity(const PlaneChoice& p)
      : start(p.axis / norm(p.axis)), substance(p.substance), turnsAway(p.turnsAway) {}
  Cut findCut(const CellContext& cell) const override {
    const Vector* inherited = cell.inheritedPolarity();
    Vector polarity = inherited ? *inherited : start;
    if (!substance.empty())
      if (const std::optional<Vector> contact = contactDirection(cell, substance))
        polarity = turnsAway ? -*contact : *contact;
    Cut cut = throughCentre(cell, polarity);
    cut.polarity = polarity;
    return cut;
  }
  Vector start;
  std::string substance;  // empty: the direction never turns
  bool turnsAway;
};

}  // namespace

const DivisionPlaneKind polarityPlane{
    .plane = DivisionPlane::polarity,
    .name = "polarity",
    .meaning =
        "a polarity that points to daughter A, which the egg has as given and daughters inherit (one that "
        "turns-towards or turns-away-from a substance first turns to the contact with cells that hold it)",
    .takes = Takes::polarity,
    .keepsPolarity = true,
    .make = makeFromChoice<Polarity>,
};

}  // namespace morula

#include "division/policy.h"

#include <algorithm>

#include "base/error.h"
#include "biology/substance_pattern.h"

namespace morula {

std::span<const DivisionPlaneKind> divisionPlanes() {
  static const DivisionPlaneKind kinds[] = {
      longestPlane, randomPlane,   axisPlane,      alternatingPlane,   smallestAreaPlane, towardsPlane, awayFromPlane,
      acrossPlane,  polarityPlane, shellAxisPlane, perpendicularPlane, parallelPlane,     tensionPlane,
  };
  return kinds;
}

const DivisionPlaneKind& kindOf(DivisionPlane plane) {
  const auto kinds = divisionPlanes();
  const auto at = std::ranges::find(kinds, plane, &DivisionPlaneKind::plane);
  MORULA_CHECK(at != kinds.end(), "a division plane without a row");
  return *at;
}

bool keepsPolarity(const DivisionParameters& p) {
  const auto keeps = [](const PlaneChoice& choice) { return kindOf(choice.plane).keepsPolarity; };
  return keeps(p.otherwise) ||
         std::ranges::any_of(p.rules, [&](const DivisionRule& rule) { return rule.plane && keeps(*rule.plane); });
}

std::unique_ptr<DivisionPolicy> makePlanePolicy(const PlaneChoice& choice, std::uint64_t seed) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  if ((kind.takes == Takes::axis || kind.takes == Takes::polarity) && !(norm(choice.axis) > 0))
    throw InputError::at("division.plane", ": the axis has no length; give a direction such as [1, 0, 0]");
  return kind.make(choice, seed);
}

}  // namespace morula

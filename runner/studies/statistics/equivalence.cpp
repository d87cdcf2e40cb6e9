#include "statistics/equivalence.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "statistics/distributions.h"

namespace morula {

const char* name(Equivalent e) {
  constexpr const char* names[] = {"equivalent", "different", "not decided"};
  return names[static_cast<int>(e)];
}

Equivalence testEquivalence(const MeanDifference& d, double margin) {
  MORULA_CHECK(margin > 0, "a margin is above 0");
  Equivalence e{.margin = margin, .interval = intervalOf(d, 0.9)};
  const double size = std::abs(d.difference);
  if (d.standardError == 0) {
    e.pAbove = d.difference > -margin ? 0.5 * d.smallestP : 1;
    e.pBelow = d.difference < margin ? 0.5 * d.smallestP : 1;
    e.pBeyond = size > margin ? d.smallestP : 1;
  } else {
    const auto above = [&](double distance) { return studentAbove(distance / d.standardError, d.degreesOfFreedom); };
    e.pAbove = std::max(above(d.difference + margin), 0.5 * d.smallestP);
    e.pBelow = std::max(above(margin - d.difference), 0.5 * d.smallestP);
    // Of a true difference of +margin or −margin: so far from 0 on its own side, or on the other.
    e.pBeyond = std::max(std::min(1.0, above(size - margin) + above(size + margin)), d.smallestP);
  }
  e.p = std::max(e.pAbove, e.pBelow);
  return e;
}

Equivalent verdictOf(double p, double pBeyond) {
  return p < 0.05 ? Equivalent::yes : pBeyond < 0.05 ? Equivalent::no : Equivalent::undecided;
}

}  // namespace morula

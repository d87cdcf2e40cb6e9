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
  if (d.standardError == 0) {
    e.pAbove = d.difference > -margin ? 0 : 1;
    e.pBelow = d.difference < margin ? 0 : 1;
  } else {
    e.pAbove = studentAbove((d.difference + margin) / d.standardError, d.degreesOfFreedom);
    e.pBelow = studentAbove((margin - d.difference) / d.standardError, d.degreesOfFreedom);
  }
  e.p = std::max(e.pAbove, e.pBelow);
  if (d.standardError == 0) e.pBeyond = 1 - e.p;
  else
    e.pBeyond = std::min(studentAbove((d.difference - margin) / d.standardError, d.degreesOfFreedom),
                         studentAbove((-margin - d.difference) / d.standardError, d.degreesOfFreedom));
  return e;
}

Equivalent verdictOf(double p, double pBeyond) {
  return p < 0.05 ? Equivalent::yes : pBeyond < 0.05 ? Equivalent::no : Equivalent::undecided;
}

}  // namespace morula

#include "statistics/equivalence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/error.h"
#include "statistics/distributions.h"

namespace morula {

Equivalence testEquivalence(const MeanDifference& d, double margin) {
  MORULA_CHECK(margin > 0, "a margin is above 0");
  Equivalence e{.margin = margin, .interval = intervalOf(d, 0.9)};
  const double size = std::abs(d.difference);
  if (d.standardError == 0) {
    e.pAbove = d.difference > -margin ? 0.5 * d.smallestP : 1;
    e.pBelow = d.difference < margin ? 0.5 * d.smallestP : 1;
    e.pBeyond = size > margin ? d.smallestP : 1;
  } else {
    const auto estimate = d.estimate();
    e.pAbove = std::max(chanceAbove(estimate, -margin), 0.5 * d.smallestP);
    e.pBelow = std::max(chanceBelow(estimate, margin), 0.5 * d.smallestP);
    // For a true difference of +margin or −margin: the chance of `size` on its own side, and by Student on the other.
    const double own = d.difference > 0 ? chanceAbove(estimate, margin) : chanceBelow(estimate, -margin);
    const double other = studentAbove((size + margin) / d.standardError, d.degreesOfFreedom);
    e.pBeyond = std::max(std::min(1.0, own + other), d.smallestP);
  }
  e.p = std::max(e.pAbove, e.pBelow);
  return e;
}

Equivalent verdictOf(double p, double pBeyond) {
  return p < 0.05 ? Equivalent::yes : pBeyond < 0.05 ? Equivalent::no : Equivalent::undecided;
}

std::vector<double> correctHolm(std::span<const double> p) {
  std::vector<std::size_t> order(p.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> corrected(p.size());
  double least = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    least = std::max(least, std::min(1.0, p[order[i]] * static_cast<double>(p.size() - i)));
    corrected[order[i]] = least;
  }
  return corrected;
}

}  // namespace morula

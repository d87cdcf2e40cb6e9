#pragma once
// Are two means the same but for a margin? Two one-sided tests [Schuirmann 1987].
#include <string>

#include "statistics/compare_means.h"

namespace morula {

enum class Equivalent { yes, no, undecided };
/// "equivalent", "different", "not decided".
const char* name(Equivalent e);

/// With a margin > 0. Both tests are at 5 %: the means are equivalent if the 90 % interval of their difference lies
/// within ±margin, and different if it lies outside: then they differ by more than the margin, not only from
/// each other. A difference that does not vary is no estimate, and is held against the margin itself.
struct Equivalence {
  double margin = 0;
  double pAbove = 1;    // that the difference is at −margin or below: small if it lies above
  double pBelow = 1;    // that it is at +margin or above: small if it lies below
  double p = 1;         // the larger: of equivalence
  double pBeyond = 1;   // of the opposite, that the difference is larger than the margin, on either side
  Interval interval{};  // of the difference, at 90 %
};
Equivalence testEquivalence(const MeanDifference& d, double margin);

/// What the p-values, as they are or corrected, say at 5 %.
Equivalent verdictOf(double p, double pBeyond);

}  // namespace morula

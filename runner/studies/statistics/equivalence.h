#pragma once
// Are two means equal within a margin? Two one-sided tests [Schuirmann 1987]. And a correction for several tests: the
// more tests, the more of them find a difference where there is none.
#include <span>
#include <vector>

#include "base/choice.h"
#include "statistics/means.h"

namespace morula {

enum class Equivalent { yes, no, undecided, untested };
template <>
inline constexpr auto choices<Equivalent> = std::to_array<Choice<Equivalent>>(
    {{Equivalent::yes, "equivalent", "alike within the margin"},
     {Equivalent::no, "different", "apart by more than the margin"},
     {Equivalent::undecided, "not decided", "neither is shown"},
     {Equivalent::untested, "not tested", "no two means could differ by the margin"}});

/// A test of equivalence with a margin > 0. The means are equivalent if both one-sided tests at 5 % agree: then the 90
/// % interval of their difference lies within ±margin. They are different if their difference exceeds the margin at 5
/// %. With a margin far below the error this is the two-sided test of a difference, far above the error a one-sided
/// test. Intervals and p-values suit the shape of the differences (mean_estimate.h). A difference that does not vary
/// has p-values of the exact test of its signs. A difference of single runs that no seed changes is compared with the
/// margin itself.
struct Equivalence {
  double margin = 0;
  double pAbove = 1;                   // p of a difference at −margin or below: small if the difference lies above
  double pBelow = 1;                   // p of a difference at +margin or above: small if the difference lies below
  double p = 1;                        // p of equivalence: the larger of both
  double pBeyond = 1;                  // p of chance, for a difference beyond the margin on either side
  std::optional<Interval> interval{};  // interval of the difference, at 90 %; absent if it does not vary
};
Equivalence testEquivalence(const MeanDifference& d, double margin);

/// Returns the verdict of p-values, as they are or corrected, at 5 %.
Equivalent verdictOf(double p, double pBeyond);

/// Corrects the p-values of a family of tests: if values below 0.05 are called differences, at most 5 % of such
/// families have any false one [Holm 1979]. In rising order the i-th of m (from 0) is multiplied by m − i, is at least
/// its predecessor, and at most 1. The result is in the order given.
std::vector<double> correctHolm(std::span<const double> p);

}  // namespace morula

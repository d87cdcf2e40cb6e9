#pragma once
// Are two means the same but for a margin? Two one-sided tests [Schuirmann 1987]. And several tests at once: the more
// are made, the more of them find a difference where there is none.
#include <span>
#include <vector>

#include "base/choice.h"
#include "statistics/means.h"

namespace morula {

enum class Equivalent { yes, no, undecided };
template <>
inline constexpr auto choices<Equivalent> =
    std::to_array<Choice<Equivalent>>({{Equivalent::yes, "equivalent", "alike within the margin"},
                                       {Equivalent::no, "different", "apart by more than the margin"},
                                       {Equivalent::undecided, "not decided", "neither is shown"}});

/// Tests equivalence with a margin > 0. The means are equivalent if both one-sided tests at 5 % say so, which is if the
/// 90 % interval of their difference lies within ±margin; and different if their difference is larger than the margin
/// at 5 %: with a margin far below the error that is the two-sided test of a difference, with one far above it a
/// one-sided test. A difference that does not vary has p-values of the exact test of its signs, or where it is of one
/// run each and no seed changes it, is held against the margin itself.
struct Equivalence {
  double margin = 0;
  double pAbove = 1;                   // that the difference is at −margin or below: small if it lies above
  double pBelow = 1;                   // that it is at +margin or above: small if it lies below
  double p = 1;                        // the larger: of equivalence
  double pBeyond = 1;                  // of a difference larger than the margin, on either side, being chance
  std::optional<Interval> interval{};  // of the difference, at 90 %; absent where it does not vary
};
Equivalence testEquivalence(const MeanDifference& d, double margin);

/// Returns the verdict of p-values, as they are or corrected, at 5 %.
Equivalent verdictOf(double p, double pBeyond);

/// p-values of a family of tests, corrected so that if those below 0.05 are called differences, at most 5 % of such
/// families have any false one among them [Holm 1979]: in rising order the i-th of m (from 0) is taken (m − i) times,
/// is at least the one before, and at most 1. In the order given.
std::vector<double> correctHolm(std::span<const double> p);

}  // namespace morula

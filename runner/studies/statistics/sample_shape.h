#pragma once
// The shape of a sample: what it shows of the distribution of its values. Student's interval of a mean takes values to
// vary alike on both sides of it. From few values of a skewed distribution, or of one with two groups, the interval
// holds the mean less often than it says (coverage.h).
#include <cstddef>
#include <span>

#include "base/choice.h"

namespace morula {

enum class SampleShape { plain, skewed, twoGroups };
template <>
inline constexpr auto choices<SampleShape> = std::to_array<Choice<SampleShape>>(
    {{SampleShape::plain, "plain", "shows neither skewness nor groups: Student's interval"},
     {SampleShape::skewed, "skewed", "skewed: Student's interval is widened to the one corrected for skewness"},
     {SampleShape::twoGroups, "two groups", "two groups of values: the interval is of the share of the upper group"}});

/// The values below and above the widest gap between neighbouring values.
struct TwoGroups {
  double low = 0, high = 0;  // mean of each group
  std::size_t countLow = 0, countHigh = 0;
  double squares = 0;    // sum of squared deviations from the means of the groups
  bool repeats = false;  // each group has one value but for rounding
  std::size_t count() const { return countLow + countHigh; }
  double gap() const { return high - low; }
};

struct ShapedSample {
  SampleShape shape = SampleShape::plain;
  double skewness = 0;    // unbiased estimate G₁ [Joanes & Gill 1998]; 0 for fewer than five values
  TwoGroups groups = {};  // with SampleShape::twoGroups
};

/// Returns the shape of a sample.
///
/// Two groups: three values or more that are two numbers, or five or more of which both groups vary little. The sum of
/// squares within groups is then below a share of the sum of squares about the mean: 0.015 (n − 4), at most 0.08, which
/// at most 1.2 % of normal samples are below.
///
/// Skewed: five values or more whose skewness 5 % of normal samples exceed [D'Agostino 1970].
ShapedSample shapeOf(std::span<const double> values);

}  // namespace morula

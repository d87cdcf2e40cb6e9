#pragma once
// The estimate of a mean from a sample, with intervals and one-sided tests that suit the sample's shape.
//
// A plain sample has Student's. With t = (mean − μ) / e, e the standard error, t follows Student's distribution of n −
// 1 degrees of freedom.
//
// A skewed sample has a t whose quantiles lie farther out on the side of the long tail. By the Edgeworth series of t to
// first order, the quantile q becomes
//
//   t = q + γ (1 + 2 q²) / (6 √n),   γ the skewness of the values
//
// [Johnson 1978; Hall 1988]. The end of the interval on the side of the long tail moves out so far; the other, which
// would move in, stays. The p-value of t is that of its q.
//
// Two groups: with the means a < b of the groups, μ = a + (b − a) π for the share π of the upper group among all runs,
// whose interval is exact [Clopper & Pearson 1934]. The variation within groups adds Student's half width of the mean
// deviation from the groups' means; both half widths are added as squares [Zou & Donner 2008]. Where groups vary, the
// interval holds Student's, too: then the groups may be chance.
#include <cstddef>

#include "statistics/sample_shape.h"

namespace morula {

struct Interval {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

struct MeanEstimate {
  double mean = 0, standardError = 0, degreesOfFreedom = 0;
  std::size_t n = 0;
  ShapedSample sample = {};
  /// True for differences of pairs. If one group lies at 0 and the other at d, differences of −d may occur, too, unseen
  /// among n; the interval allows for as many as n pairs may miss.
  bool isDifference = false;
};

/// Returns the interval of Clopper and Pearson of a share, of which `count` in n are seen.
Interval intervalOfShare(std::size_t count, std::size_t n, double level);

/// Returns Student's interval, for whatever shape.
Interval studentInterval(const MeanEstimate& estimate, double level);
/// Returns the interval that suits the sample's shape. Requires a standard error above 0.
Interval intervalOf(const MeanEstimate& estimate, double level);

/// Returns the chance of such an estimate or a higher one if the true mean is `value` (or lower): the p-value of a test
/// whose alternative is a mean above `value`. Requires a standard error above 0.
double chanceAbove(const MeanEstimate& estimate, double value);
/// Returns the chance of such an estimate or a lower one if the true mean is `value`.
double chanceBelow(const MeanEstimate& estimate, double value);

}  // namespace morula

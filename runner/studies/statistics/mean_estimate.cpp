#include "statistics/mean_estimate.h"

#include <algorithm>
#include <cmath>

#include "statistics/distributions.h"

namespace morula {
namespace {

/// Returns γ / (6 √n), and 0 or above.
double stretchOf(const MeanEstimate& e) {
  return std::abs(e.sample.skewness) / (6 * std::sqrt(static_cast<double>(e.n)));
}

/// Returns the q of a t on the side of the long tail: the root of 2 c q² + q + c − t = 0, with c = γ / (6 √n) above 0.
double quantileOf(double t, double c) { return (std::sqrt(1 + 8 * c * std::max(t - c, 0.0)) - 1) / (4 * c); }

Interval hull(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

Interval skewedInterval(const MeanEstimate& e, double level) {
  const double q = studentQuantile(0.5 + 0.5 * level, e.degreesOfFreedom);
  const double far = q + stretchOf(e) * (1 + 2 * q * q);
  const bool isTailHigh = e.sample.skewness > 0;
  return {e.mean - (isTailHigh ? q : far) * e.standardError, e.mean + (isTailHigh ? far : q) * e.standardError};
}

Interval groupsInterval(const MeanEstimate& e, double level) {
  const TwoGroups& g = e.sample.groups;
  const double n = static_cast<double>(g.count()), gap = g.gap(), share = static_cast<double>(g.countHigh) / n;
  const Interval shares = intervalOfShare(g.countHigh, g.count(), level);
  const double df = n - 2;
  const double within = g.repeats ? 0 : studentQuantile(0.5 + 0.5 * level, df) * std::sqrt(g.squares / df / n);
  const double unseen = e.isDifference ? intervalOfShare(0, g.count(), level).high : 0;
  // A group counts as 0 if it lies within a tenth of the gap.
  const double below = std::abs(g.low) < 0.1 * gap ? unseen : 0, above = std::abs(g.high) < 0.1 * gap ? unseen : 0;
  const auto halfWidth = [&](double ofShare, double opposite) {
    return std::sqrt(gap * gap * (ofShare * ofShare + opposite * opposite) + within * within);
  };
  return {e.mean - halfWidth(share - shares.low, below), e.mean + halfWidth(shares.high - share, above)};
}

/// Returns the one-sided p-value at which the interval's lower end (`low`), or its upper one, is `value`, to 3e-8.
double chanceByIntervals(const MeanEstimate& e, double value, bool low) {
  double least = 0, most = 1;  // of p
  for (int turn = 0; turn < 24; ++turn) {
    const double p = 0.5 * (least + most);
    const Interval i = intervalOf(e, 1 - p);
    const bool holds = low ? i.low <= value : i.high >= value;
    (holds ? least : most) = p;
  }
  return 0.5 * most;
}

double chance(const MeanEstimate& e, double value, bool above) {
  const double t = (above ? 1 : -1) * (e.mean - value) / e.standardError;
  const double plain = studentAbove(t, e.degreesOfFreedom);
  switch (e.sample.shape) {
    case SampleShape::plain: break;
    case SampleShape::skewed: {
      const bool isTail = above ? e.sample.skewness < 0 : e.sample.skewness > 0;  // `value` lies on its side
      return isTail && t > 0 ? studentAbove(quantileOf(t, stretchOf(e)), e.degreesOfFreedom) : plain;
    }
    case SampleShape::twoGroups: return t > 0 ? chanceByIntervals(e, value, above) : plain;
  }
  return plain;
}

}  // namespace

Interval intervalOfShare(std::size_t count, std::size_t n, double level) {
  const double k = static_cast<double>(count), rest = static_cast<double>(n - count), tail = 0.5 - 0.5 * level;
  return {count > 0 ? betaQuantile(tail, k, rest + 1) : 0, count < n ? betaQuantile(1 - tail, k + 1, rest) : 1};
}

Interval studentInterval(const MeanEstimate& e, double level) {
  const double half = studentQuantile(0.5 + 0.5 * level, e.degreesOfFreedom) * e.standardError;
  return {e.mean - half, e.mean + half};
}

Interval intervalOf(const MeanEstimate& e, double level) {
  const ShapedSample& sample = e.sample;
  if (sample.shape == SampleShape::twoGroups && sample.groups.repeats) return groupsInterval(e, level);
  const Interval plain = studentInterval(e, level);
  switch (sample.shape) {
    case SampleShape::plain: break;
    case SampleShape::skewed: return skewedInterval(e, level);
    case SampleShape::twoGroups: return hull(plain, groupsInterval(e, level));
  }
  return plain;
}

double chanceAbove(const MeanEstimate& e, double value) { return chance(e, value, true); }
double chanceBelow(const MeanEstimate& e, double value) { return chance(e, value, false); }

}  // namespace morula

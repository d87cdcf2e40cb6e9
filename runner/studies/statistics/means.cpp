#include "statistics/means.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "base/maths.h"
#include "statistics/distributions.h"
#include "statistics/sign_flip.h"

namespace morula {
namespace {

std::vector<double> differences(std::span<const double> a, std::span<const double> b) {
  MORULA_CHECK(a.size() == b.size() && a.size() > 1, "pairs, two at least");
  std::vector<double> all(a.size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = a[i] - b[i];
  return all;
}

MeanDifference test(double difference, double standardError, double df) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  MeanDifference d{.difference = difference, .standardError = standardError, .degreesOfFreedom = df};
  if (standardError > 0) d.t = difference / standardError;
  else if (difference != 0) d.t = difference > 0 ? infinity : -infinity;
  d.p = studentBeyond(d.t, df);
  return d;
}

}  // namespace

double mean(std::span<const double> values) {
  MORULA_CHECK(!values.empty(), "a mean is of something");
  double sum = 0;
  for (const double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

double variance(std::span<const double> values) {
  MORULA_CHECK(values.size() > 1, "a variance is of two values at least");
  // The mean's rounding would make equal values differ from it.
  if (std::ranges::all_of(values, [&](double x) { return x == values.front(); })) return 0;
  const double centre = mean(values);
  double squares = 0;
  for (const double x : values) squares += (x - centre) * (x - centre);
  return squares / static_cast<double>(values.size() - 1);
}

std::optional<Interval> intervalOfMean(std::span<const double> values, double level) {
  if (values.size() < 2) return std::nullopt;
  const double n = static_cast<double>(values.size()), spread = variance(values);
  if (spread == 0) return std::nullopt;
  return intervalOf(MeanEstimate{mean(values), std::sqrt(spread / n), n - 1, values.size(), shapeOf(values)}, level);
}

MeanEstimate MeanDifference::estimate() const {
  return {difference, standardError, degreesOfFreedom, pairs, sample, true};
}

std::optional<Interval> intervalOf(const MeanDifference& d, double level) {
  if (d.standardError == 0) return std::nullopt;
  return intervalOf(d.estimate(), level);
}

MeanDifference comparePaired(std::span<const double> a, std::span<const double> b) {
  const auto d = differences(a, b);
  const double n = static_cast<double>(d.size()), spread = variance(d);
  MeanDifference result = test(spread == 0 ? d.front() : mean(d), std::sqrt(spread / n), n - 1);
  result.pairs = d.size(), result.sample = shapeOf(d);
  result.interval = intervalOf(result, 0.95);
  if (result.sample.shape == SampleShape::skewed) {
    const auto estimate = result.estimate();
    result.p = std::max(result.p, 2 * (result.t > 0 ? chanceAbove(estimate, 0) : chanceBelow(estimate, 0)));
    result.p = std::min(result.p, 1.0);
  }
  if (result.sample.shape != SampleShape::twoGroups && !repeats(d)) return result;
  result.smallestP = smallestSignFlipP(d.size());
  result.p = std::max(result.p, signFlipP(d));
  return result;
}

MeanDifference compareUnpaired(std::span<const double> a, std::span<const double> b) {
  const double na = static_cast<double>(a.size()), nb = static_cast<double>(b.size());
  const double ea = variance(a) / na, eb = variance(b) / nb, e = ea + eb;
  // Welch & Satterthwaite; any number does without variance
  const double df = e > 0 ? e * e / (ea * ea / (na - 1) + eb * eb / (nb - 1)) : na + nb - 2;
  MeanDifference result = test(mean(a) - mean(b), std::sqrt(e), df);
  result.interval = intervalOf(result, 0.95);
  if (e > 0) return result;
  double ways = 1;  // ways to choose a's values among all
  for (std::size_t i = 1; i <= a.size(); ++i) ways *= static_cast<double>(b.size() + i) / static_cast<double>(i);
  result.smallestP = 2 / ways;
  result.p = std::max(result.p, result.smallestP);
  return result;
}

double hedgesFactor(double df) {
  return exponential(logGamma(0.5 * df) - logGamma(0.5 * (df - 1))) / std::sqrt(0.5 * df);
}

EffectSizes effectSizes(std::span<const double> a, std::span<const double> b) {
  EffectSizes sizes;
  const auto d = differences(a, b);
  if (const double spread = variance(d); spread > 0) sizes.dz = mean(d) / std::sqrt(spread);
  if (const double spread = 0.5 * (variance(a) + variance(b)); spread > 0) {
    sizes.d = (mean(a) - mean(b)) / std::sqrt(spread);
    sizes.g = *sizes.d * hedgesFactor(2 * static_cast<double>(a.size() - 1));
  }
  return sizes;
}

Signs signsOf(std::span<const double> a, std::span<const double> b) {
  MORULA_CHECK(a.size() == b.size(), "pairs");
  Signs signs;
  for (std::size_t i = 0; i < a.size(); ++i) ++(a[i] > b[i] ? signs.higher : a[i] < b[i] ? signs.lower : signs.same);
  return signs;
}

}  // namespace morula

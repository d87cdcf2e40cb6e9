#pragma once
// Means with their uncertainty, and comparisons of two means: Student's t for pairs, or what suits their shape
// (mean_estimate.h), Welch's t for unpaired samples, and effect sizes.
#include <cstddef>
#include <optional>
#include <span>

#include "statistics/mean_estimate.h"

namespace morula {

/// Returns the arithmetic mean, summed in the order given. Requires at least one value.
double mean(std::span<const double> values);
/// Returns Σ (x − mean)² / (n − 1); 0 if all numbers are equal. Requires at least two values.
double variance(std::span<const double> values);

/// Returns the interval of the mean that suits the sample's shape (sample_shape.h): Student's, unless values are skewed
/// or form two groups. For normal values its coverage is the level, 0.95 for 95 %, for any n; for others see
/// coverage.h. Absent for fewer than two values, and for equal values: these do not tell how far the next may lie.
std::optional<Interval> intervalOfMean(std::span<const double> values, double level = 0.95);

/// The difference of two means, with its uncertainty.
struct MeanDifference {
  double difference = 0;  // mean of a − mean of b
  double standardError = 0, degreesOfFreedom = 0;
  double t = 0;           // difference / standardError; ±∞ if nothing varies and the means differ
  double p = 1;           // two-sided; at least smallestP
  double smallestP = 0;   // if values repeat or form two groups: smallest p of an exact test of as many (sign_flip.h)
  ShapedSample sample{};  // shape of the differences of pairs; plain if samples are unpaired
  std::size_t pairs = 0;  // 0 if samples are unpaired
  std::optional<Interval> interval{};  // at 95 %, by mean_estimate.h; absent if nothing varies

  MeanEstimate estimate() const;
};

/// Returns the interval of the difference at another level.
std::optional<Interval> intervalOf(const MeanDifference& d, double level);

/// Compares pairs (a[i], b[i]), two at least, by Student's t of their differences. If differences are skewed, p is at
/// least that of the corrected t (mean_estimate.h). If they repeat or form two groups, it is at least that of the exact
/// test (sign_flip.h).
MeanDifference comparePaired(std::span<const double> a, std::span<const double> b);

/// Compares two samples of two values at least, whose variances may differ [Welch 1947]. If neither varies, p is that
/// of the exact test: 2 over the number of ways to deal out the values.
MeanDifference compareUnpaired(std::span<const double> a, std::span<const double> b);

/// Differences in standard deviations. Absent if nothing varies.
struct EffectSizes {
  std::optional<double> dz;  // mean of the differences over their standard deviation, as in a paired test
  std::optional<double> d;   // difference over the root of the mean of both variances [Cohen 1988]
  std::optional<double> g;   // d without its bias of small samples [Hedges 1981], df = 2 (n − 1)
};
EffectSizes effectSizes(std::span<const double> a, std::span<const double> b);

/// Returns the factor that removes a standardised difference's bias: Γ(df/2) / (√(df/2) Γ((df − 1)/2)), df > 1.
double hedgesFactor(double df);

/// The numbers of pairs in which a is above b, below b and equal to b.
struct Signs {
  std::size_t higher = 0, lower = 0, same = 0;
  std::size_t pairs() const { return higher + lower + same; }
};
Signs signsOf(std::span<const double> a, std::span<const double> b);

}  // namespace morula

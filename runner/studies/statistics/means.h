#pragma once
// Means and how sure they are, and two of them held against each other: Student's t for pairs, Welch's for samples that
// are not paired, and how large the difference is.
#include <cstddef>
#include <optional>
#include <span>

namespace morula {

struct Interval {
  double low = 0, high = 0;
  double width() const { return high - low; }
};

/// The arithmetic mean, summed in the order given. Not of nothing.
double mean(std::span<const double> values);
/// Σ (x − mean)² / (n − 1); 0 if all are the same number. Of two values at least.
double variance(std::span<const double> values);

/// Student's interval of the mean, which holds it at the level, 0.95 of 95 %, whatever n if values are normal. Of 10,
/// 20 values of a strongly skewed distribution (exponential) it holds the mean in 90, 92 %. Absent for fewer than two
/// values, and where they do not vary: n equal values do not say how far the next one may lie.
std::optional<Interval> intervalOfMean(std::span<const double> values, double level = 0.95);

/// The difference of two means and how sure it is.
struct MeanDifference {
  double difference = 0;  // mean of a − mean of b
  double standardError = 0, degreesOfFreedom = 0;
  double t = 0;                        // difference / standardError; ±∞ where nothing varies and the means differ
  double p = 1;                        // two-sided; at least smallestP
  double smallestP = 0;                // where values repeat: that of an exact test of as many (sign_flip.h)
  std::optional<Interval> interval{};  // at 95 %, Student's; absent where nothing varies
};

/// The interval of the difference at another level.
std::optional<Interval> intervalOf(const MeanDifference& d, double level);

/// Compares pairs (a[i], b[i]), two at least, by Student's t of their differences. Where differences repeat, p is at
/// least that of the exact test.
MeanDifference comparePaired(std::span<const double> a, std::span<const double> b);

/// Compares two samples of two values at least, whose variances may differ [Welch 1947]. Where neither varies, p is
/// that of the exact test: of all ways to deal out the values, how many part them as they are.
MeanDifference compareUnpaired(std::span<const double> a, std::span<const double> b);

/// Differences in standard deviations. Absent where nothing varies.
struct EffectSizes {
  std::optional<double> dz;  // mean of the differences over their standard deviation: what a paired test sees
  std::optional<double> d;   // over the root of the mean of both variances [Cohen 1988]
  std::optional<double> g;   // the same without its bias of small samples [Hedges 1981], df = 2 (n − 1)
};
EffectSizes effectSizes(std::span<const double> a, std::span<const double> b);

/// The factor that takes the bias off a standardised difference: Γ(df/2) / (√(df/2) Γ((df − 1)/2)), df > 1.
double hedgesFactor(double df);

/// In how many of the pairs a is above b, below and the same.
struct Signs {
  std::size_t higher = 0, lower = 0, same = 0;
  std::size_t pairs() const { return higher + lower + same; }
};
Signs signsOf(std::span<const double> a, std::span<const double> b);

}  // namespace morula

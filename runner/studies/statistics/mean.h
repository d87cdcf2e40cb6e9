#pragma once
// Means and how sure they are.
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

/// Student's interval of the mean, which holds it at the level, 0.95 of 95 %, whatever n if values are normal. Of 10, 20
/// values of a strongly skewed distribution (exponential) it holds the mean in 90, 92 %. Absent for fewer than two values, and
/// where they do not vary: n equal values do not say how far the next one may lie.
std::optional<Interval> intervalOfMean(std::span<const double> values, double level = 0.95);

}  // namespace morula

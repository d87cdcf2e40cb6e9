#include "statistics/mean.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "statistics/distributions.h"

namespace morula {

double mean(std::span<const double> values) {
  MORULA_CHECK(!values.empty(), "a mean is of something");
  double sum = 0;
  for (const double x : values) sum += x;
  return sum / static_cast<double>(values.size());
}

double variance(std::span<const double> values) {
  MORULA_CHECK(values.size() > 1, "a variance is of two values at least");
  // Without this the rounding of the mean would make equal values differ from it.
  if (std::ranges::all_of(values, [&](double x) { return x == values.front(); })) return 0;
  const double centre = mean(values);
  double squares = 0;
  for (const double x : values) squares += (x - centre) * (x - centre);
  return squares / static_cast<double>(values.size() - 1);
}

std::optional<Interval> intervalOfMean(std::span<const double> values, double level) {
  if (values.size() < 2) return std::nullopt;
  const double n = static_cast<double>(values.size()), spread = variance(values), centre = mean(values);
  if (spread == 0) return std::nullopt;
  const double half = studentQuantile(0.5 + 0.5 * level, n - 1) * std::sqrt(spread / n);
  return Interval{centre - half, centre + half};
}

}  // namespace morula

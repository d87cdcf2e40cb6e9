#include "statistics/sample_shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "statistics/sign_flip.h"

namespace morula {
namespace {

/// Sums of powers of the deviations from the mean.
struct Moments {
  double squares = 0, cubes = 0;

  explicit Moments(std::span<const double> values) {
    double sum = 0;
    for (const double x : values) sum += x;
    const double centre = sum / static_cast<double>(values.size());
    for (const double x : values) {
      const double d = x - centre;
      squares += d * d, cubes += d * d * d;
    }
  }
};

/// Returns the skewness m₃ / m₂^(3/2) that 5 % of normal samples exceed on either side.
double largeSkewness(double n) {
  // Below eight values the approximation has no root; these are quantiles of 200,000 samples, to 0.01.
  if (n < 6) return 1.21;
  if (n < 7) return 1.24;
  if (n < 8) return 1.23;
  // Z = δ arsinh(Y/α) is normal for Y = skewness √((n + 1)(n + 3) / (6 (n − 2))); here solved for Z = 1.96.
  const double kurtosis = 3 * (n * n + 27 * n - 70) * (n + 1) * (n + 3) / ((n - 2) * (n + 5) * (n + 7) * (n + 9));
  const double w2 = std::sqrt(2 * (kurtosis - 1)) - 1;
  const double delta = 1 / std::sqrt(0.5 * naturalLog(w2)), alpha = std::sqrt(2 / (w2 - 1));
  const double e = exponential(1.959963984540054 / delta);
  return 0.5 * (e - 1 / e) * alpha / std::sqrt((n + 1) * (n + 3) / (6 * (n - 2)));
}

TwoGroups splitAtWidestGap(std::span<const double> values) {
  std::vector<double> rising(values.begin(), values.end());
  std::ranges::sort(rising);
  std::size_t below = 1;
  for (std::size_t i = 2; i < rising.size(); ++i)
    if (rising[i] - rising[i - 1] > rising[below] - rising[below - 1]) below = i;
  const std::span low(rising.data(), below), high(rising.data() + below, rising.size() - below);
  TwoGroups groups{.countLow = low.size(), .countHigh = high.size()};
  for (const double x : low) groups.low += x / static_cast<double>(low.size());
  for (const double x : high) groups.high += x / static_cast<double>(high.size());
  groups.squares = Moments(low).squares + Moments(high).squares;
  const double tie = tieOf(rising);
  groups.repeats = low.back() - low.front() <= tie && high.back() - high.front() <= tie;
  return groups;
}

}  // namespace

ShapedSample shapeOf(std::span<const double> values) {
  ShapedSample sample;
  const std::size_t count = values.size();
  if (count < 3) return sample;
  const auto [least, most] = std::ranges::minmax(values);
  if (most - least <= tieOf(values)) return sample;
  const double n = static_cast<double>(count);
  const Moments about(values);
  const double skewness = about.cubes / n / ((about.squares / n) * std::sqrt(about.squares / n));
  if (count >= 5) sample.skewness = skewness * std::sqrt(n * (n - 1)) / (n - 2);
  const TwoGroups groups = splitAtWidestGap(values);
  const double little = count < 5 ? 0 : std::min(0.015 * (n - 4), 0.08);
  if (groups.repeats || groups.squares < little * about.squares)
    sample.shape = SampleShape::twoGroups, sample.groups = groups;
  else if (count >= 5 && std::abs(skewness) > largeSkewness(n)) sample.shape = SampleShape::skewed;
  return sample;
}

}  // namespace morula

#include "statistics/bootstrap.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "statistics/distributions.h"

namespace morula {

namespace {

/// The number at this share of the way through the sorted numbers, between neighbours in proportion. Reorders.
double quantile(std::vector<double>& numbers, double share) {
  const double place = share * static_cast<double>(numbers.size() - 1);
  const auto below = numbers.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(numbers.begin(), below, numbers.end());
  if (below + 1 == numbers.end()) return *below;
  const double next = *std::min_element(below + 1, numbers.end());
  return *below + (place - std::floor(place)) * (next - *below);
}

/// How the deviation of the mean grows with the mean: a sixth of the skewness of the jackknife's means
/// [Efron & Tibshirani 1993, eq. 14.15]. Those differ from the mean by (mean − x)/(n − 1).
double acceleration(std::span<const double> values, double centre) {
  double squares = 0, cubes = 0;
  for (const double x : values) {
    const double u = x - centre;
    squares += u * u, cubes += u * u * u;
  }
  return squares > 0 ? cubes / (6 * squares * std::sqrt(squares)) : 0;
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
  // Without this the rounding of the mean would make equal values differ from it.
  if (std::ranges::all_of(values, [&](double x) { return x == values.front(); })) return 0;
  const double centre = mean(values);
  double squares = 0;
  for (const double x : values) squares += (x - centre) * (x - centre);
  return squares / static_cast<double>(values.size() - 1);
}

std::span<const std::uint16_t> Bootstrap::choices(std::size_t n) {
  MORULA_CHECK(n > 0 && n < many, "so many values are not resampled");
  std::vector<std::uint16_t>& all = choices_[n];
  if (!all.empty()) return all;
  all.reserve(n * resamples);
  for (std::uint32_t r = 0; r < resamples; ++r) {
    const Draw draw{.seed = n, .cell = {}, .cycle = r, .purpose = Purpose::resampling};
    for (std::size_t i = 0; i < n; i += 4) {
      const auto words = randomWords(draw, static_cast<std::uint32_t>(i / 4));
      for (std::size_t k = 0; k < 4 && i + k < n; ++k)  // floor(n w / 2³²): a choice is off by n/2³² at most
        all.push_back(static_cast<std::uint16_t>(std::uint64_t{words[k]} * n >> 32));
    }
  }
  return all;
}

std::optional<Interval> Bootstrap::ofMean(std::span<const double> values, double level) {
  const std::size_t n = values.size();
  if (n < 2) return std::nullopt;
  const double spread = variance(values);
  if (spread == 0) return Interval{values.front(), values.front()};
  const double centre = mean(values);
  if (n >= many) {
    const double df = static_cast<double>(n - 1);
    const double half = studentQuantile(0.5 + 0.5 * level, df) * std::sqrt(spread / static_cast<double>(n));
    return Interval{centre - half, centre + half};
  }
  const auto chosen = choices(n);
  // Resamples of equal sums in another order are ties, whatever rounding made of them.
  double size = 0;
  for (const double x : values) size = std::max(size, std::abs(x));
  const double tie = 1e-13 * size;
  std::vector<double> means(resamples);
  double below = 0;
  for (std::size_t r = 0; r < resamples; ++r) {
    double sum = 0;
    for (std::size_t i = r * n; i < (r + 1) * n; ++i) sum += values[chosen[i]];
    means[r] = sum / static_cast<double>(n);
    below += means[r] < centre - tie ? 1 : means[r] <= centre + tie ? 0.5 : 0;
  }
  const double bias = normalQuantile(below / resamples), a = acceleration(values, centre);
  const double outer = normalQuantile(0.5 - 0.5 * level);
  const auto share = [&](double z) { return normalBelow(bias + (bias + z) / (1 - a * (bias + z))); };
  return Interval{quantile(means, share(outer)), quantile(means, share(-outer))};
}

}  // namespace morula

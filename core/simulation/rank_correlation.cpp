#include "simulation/rank_correlation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace morula {
namespace {

/// Of each value, less the mean of all ranks: the least is −(n − 1)/2, the largest (n − 1)/2.
std::vector<double> ranks(std::span<const double> values) {
  std::vector<std::uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return std::pair(values[i], i); });
  std::vector<double> rank(values.size());
  double largest = 0;
  for (double value : values) largest = std::max(largest, std::abs(value));
  const double middle = 0.5 * (static_cast<double>(values.size()) - 1);
  for (std::size_t first = 0; first < order.size();) {
    std::size_t end = first + 1;
    while (end < order.size() && values[order[end]] - values[order[end - 1]] <= 1e-9 * largest) ++end;
    for (std::size_t i = first; i < end; ++i) rank[order[i]] = 0.5 * static_cast<double>(first + end - 1) - middle;
    first = end;
  }
  return rank;
}

}  // namespace

std::optional<double> rankCorrelation(std::span<const double> x, std::span<const double> y) {
  const std::vector<double> a = ranks(x), b = ranks(y);
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < a.size(); ++i) xx += a[i] * a[i], xy += a[i] * b[i], yy += b[i] * b[i];
  if (!(xx > 0 && yy > 0)) return {};
  return xy / (std::sqrt(xx) * std::sqrt(yy));
}

}  // namespace morula

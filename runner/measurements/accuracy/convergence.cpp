#include "accuracy/convergence.h"

#include <algorithm>
#include <cmath>

namespace morula {
namespace {

/// Returns true for positive finite numbers; false for NaN.
bool isPositive(double a) { return a > 0 && a < INFINITY; }

constexpr double minOrder = 0.25;  // below this order nothing converges

}  // namespace

std::optional<PowerLaw> fitPowerLaw(const std::vector<XY>& points) {
  std::vector<XY> logs;
  for (const XY& p : points)
    if (isPositive(p.x) && isPositive(p.y)) logs.push_back({std::log(p.x), std::log(p.y)});
  const double n = static_cast<double>(logs.size());
  XY mean;
  for (const XY& p : logs) mean.x += p.x / n, mean.y += p.y / n;
  double xx = 0, xy = 0;
  for (const XY& p : logs) {
    xx += (p.x - mean.x) * (p.x - mean.x);
    xy += (p.x - mean.x) * (p.y - mean.y);
  }
  if (!(xx > 1e-12)) return {};
  PowerLaw law{xy / xx, 0, static_cast<int>(logs.size())};
  double residual = 0;
  for (const XY& p : logs) {
    const double off = p.y - mean.y - law.slope * (p.x - mean.x);
    residual += off * off;
  }
  if (n > 2) law.slopeError = std::sqrt(residual / (n - 2) / xx);
  return law;
}

LeftError estimateByRichardson(double coarseToMiddle, double middleToFine, double highestOrder) {
  if (middleToFine == 0) return {0, highestOrder};
  const double observed = std::log2(coarseToMiddle / middleToFine);
  if (!(observed >= minOrder)) return {std::max(coarseToMiddle, middleToFine), 0};
  const double order = std::min(observed, highestOrder);
  return {middleToFine / (std::exp2(order) - 1), order};
}

std::optional<double> costAtError(const std::vector<WorkPoint>& series, double error) {
  std::optional<double> least;
  for (std::size_t i = 1; i < series.size(); ++i) {
    const WorkPoint &a = series[i - 1], &b = series[i];
    if (!isPositive(a.error) || !isPositive(b.error) || !isPositive(a.cost) || !isPositive(b.cost)) continue;
    if (error < std::min(a.error, b.error) || error > std::max(a.error, b.error)) continue;
    const double span = std::log(b.error / a.error);
    const double share = span == 0 ? 0 : std::log(error / a.error) / span;
    const double cost = a.cost * std::exp(share * std::log(b.cost / a.cost));
    least = least ? std::min(*least, cost) : cost;
  }
  return least;
}

}  // namespace morula

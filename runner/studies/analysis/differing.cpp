#include "analysis/differing.h"

#include <algorithm>
#include <cmath>

namespace morula {
namespace {

/// [condition][measure] The means in standard deviations of all values; absent: without values, or all are the same.
std::vector<std::vector<std::optional<double>>> scaledMeans(const StudyComparison& c) {
  std::vector<std::vector<std::optional<double>>> means(c.results.conditions.size(),
                                                        std::vector<std::optional<double>>(c.results.measures.size()));
  for (const std::size_t m : c.measures) {
    double sum = 0, squares = 0, n = 0;
    for (const ConditionSummary& s : c.conditions)
      if (s.measure == m)
        for (const double v : s.values) sum += v, n += 1;
    for (const ConditionSummary& s : c.conditions)
      if (s.measure == m)
        for (const double v : s.values) squares += (v - sum / n) * (v - sum / n);
    if (squares == 0) continue;
    for (const ConditionSummary& s : c.conditions)
      if (s.measure == m && !s.values.empty()) means[s.condition][m] = s.mean / std::sqrt(squares / n);
  }
  return means;
}

}  // namespace

std::vector<std::size_t> byDifference(const StudyComparison& c) {
  const auto means = scaledMeans(c);
  const std::size_t n = means.size();
  const auto apart = [&](std::size_t a, std::size_t b) {
    double sum = 0;
    for (std::size_t m = 0; m < means[a].size(); ++m)
      if (means[a][m] && means[b][m]) sum += (*means[a][m] - *means[b][m]) * (*means[a][m] - *means[b][m]);
    return sum;
  };
  const auto isKnown = [&](std::size_t k) {
    return std::ranges::any_of(c.conditions, [&](const auto& s) { return s.condition == k && !s.values.empty(); });
  };
  // How far each is from the nearest that has been chosen; those without values are behind all others.
  std::vector<double> far(n);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) far[a] = std::max(far[a], apart(a, b));
    if (!isKnown(a)) far[a] = -1;
  }
  std::vector<std::size_t> order;
  std::vector<bool> isChosen(n);
  while (order.size() < n) {
    std::size_t best = n;
    for (std::size_t k = 0; k < n; ++k)
      if (!isChosen[k] && (best == n || far[k] > far[best])) best = k;
    isChosen[best] = true;
    order.push_back(best);
    for (std::size_t k = 0; k < n; ++k)
      if (far[k] >= 0) far[k] = order.size() == 1 ? apart(k, best) : std::min(far[k], apart(k, best));
  }
  return order;
}

}  // namespace morula

// Runs of several seeds that are one run. Where seeds change so little that no difference grows, all runs take one path
// and end alike but for rounding. Their number says nothing: they have no interval, and are not tested.
#include <algorithm>
#include <set>

#include "analysis/compare_parts.h"

namespace morula {

bool isOnePath(std::span<const double> values) {
  double low = INFINITY, high = -INFINITY, largest = 0;
  for (const double v : values)
    low = std::min(low, v), high = std::max(high, v), largest = std::max(largest, std::abs(v));
  return values.size() > 1 && high - low <= onePathSpread * largest;
}

void findOnePaths(StudyComparison& c) {
  const StudyResults& r = c.results;
  for (std::size_t i = 0; i < r.conditions.size(); ++i) {
    std::set<std::string> states;
    for (const std::size_t t : r.conditions[i].tasks)
      if (r.isDone(t)) states.insert(r.tasks[t].stateHash);
    if (states.size() < 2) continue;
    std::size_t vary = 0, little = 0;  // measures
    for (std::size_t m = 0; m < r.measures.size(); ++m) {
      std::vector<double> values;
      for (const std::size_t t : r.conditions[i].tasks)
        if (const auto value = r.end(m, t)) values.push_back(*value);
      if (values.size() < 2 || std::ranges::all_of(values, [&](double v) { return v == values[0]; })) continue;
      ++vary, little += isOnePath(values);
    }
    if (little > 0 && 2 * little >= vary) c.onePaths.push_back(i);
  }
}

}  // namespace morula

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/compare_parts.h"

namespace morula {
namespace {

ConditionSummary summaryOf(const StudyComparison& c, std::size_t measure, std::size_t condition) {
  const StudyResults& results = c.results;
  ConditionSummary summary{.measure = measure, .condition = condition};
  const auto& tasks = results.conditions[condition].tasks;
  std::set<std::size_t> seen;
  std::set<std::string> states;
  std::vector<double> distinct;  // the value of each distinct run
  for (std::size_t s = 0; s < tasks.size(); ++s) {
    const auto value = results.end(measure, tasks[s]);
    if (!value) continue;
    summary.seeds.push_back(results.seeds[s]);
    summary.values.push_back(*value);
    if (!seen.insert(tasks[s]).second) continue;
    distinct.push_back(*value);
    states.insert(results.tasks[tasks[s]].stateHash);
  }
  summary.distinct = states.size();
  if (distinct.empty()) return summary;
  summary.mean = mean(distinct);
  summary.onePath = std::ranges::binary_search(c.onePaths, condition) && isOnePath(distinct);
  if (summary.onePath || summary.distinct < 2) return summary;
  summary.interval = intervalOfMean(distinct);
  summary.shape = shapeOf(distinct).shape;
  return summary;
}

/// Returns true for several seeds that give one run, or several runs that end in one state.
bool isSeedless(const StudyResults& results, const ResultCondition& condition) {
  std::set<std::string> states;
  std::size_t done = 0;
  for (const std::size_t t : condition.tasks) {
    if (!results.isDone(t)) continue;
    ++done;
    states.insert(results.tasks[t].stateHash);
  }
  return results.seeds.size() > 1 && (!condition.usesSeed || (done > 1 && states.size() == 1));
}

/// Returns the places of the words among the names; without words all places.
std::vector<std::size_t> numbersOf(const std::string& option, const std::string& kind,
                                   const std::vector<std::string>& words, const std::vector<std::string>& names) {
  std::vector<std::size_t> numbers;
  for (const std::string& word : words.empty() ? names : words) {
    const auto name = nameAmong(option, kind, word, names);
    const auto number = static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    if (std::ranges::find(numbers, number) == numbers.end()) numbers.push_back(number);
  }
  return numbers;
}

/// Returns means in standard deviations of all values, [condition][measure]; absent without values or variance.
std::vector<std::vector<std::optional<double>>> scaledMeans(const StudyComparison& c) {
  std::vector<std::vector<std::optional<double>>> means(c.results.conditions.size(),
                                                        std::vector<std::optional<double>>(c.results.measures.size()));
  for (const std::size_t m : c.measures) {
    std::vector<double> values;
    for (const ConditionSummary& s : c.conditions)
      if (s.measure == m) values.insert(values.end(), s.values.begin(), s.values.end());
    double squares = 0;
    const double n = double(values.size()), centre = values.empty() ? 0 : mean(values);
    for (const double v : values) squares += (v - centre) * (v - centre);
    if (squares == 0) continue;
    for (const ConditionSummary& s : c.conditions)
      if (s.measure == m && !s.values.empty()) means[s.condition][m] = s.mean / std::sqrt(squares / n);
  }
  return means;
}

}  // namespace

std::vector<std::size_t> comparedAxes(const StudyComparison& comparison) {
  std::vector<std::size_t> axes;
  for (const std::size_t a : comparison.by)
    if (comparison.results.axes[a].labels.size() > 1) axes.push_back(a);
  return axes;
}

StudyComparison compareStudy(StudyResults results, const CompareOptions& options) {
  StudyComparison c;
  c.results = std::move(results);
  const StudyResults& r = c.results;
  std::vector<std::string> axes;
  for (const ResultAxis& axis : r.axes) axes.push_back(axis.name);
  c.by = numbersOf("--by", "axis", options.by, axes);
  c.measures = numbersOf("--measure", "measure", options.measures, r.measures);
  c.margins = parseMargins(options.margins, r.measures);
  for (std::size_t i = 0; i < r.conditions.size(); ++i)
    if (isSeedless(r, r.conditions[i])) c.seedless.push_back(i);
  findOnePaths(c);
  for (const std::size_t m : c.measures)
    for (std::size_t i = 0; i < r.conditions.size(); ++i) c.conditions.push_back(summaryOf(c, m, i));
  comparePairs(c, options.within);
  if (options.refuseWide) refuseWideMargins(c);
  compareFactors(c);
  splitPairs(c);
  compareOverTime(c);
  return c;
}

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
  // At first the distance to the farthest condition, then to the nearest chosen one; −1 for conditions without values.
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

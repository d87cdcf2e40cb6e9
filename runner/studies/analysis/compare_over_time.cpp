// Time courses.
#include <algorithm>
#include <cmath>

#include "analysis/compare_parts.h"

namespace morula {
namespace {

constexpr int manyTimes = 21;

/// Returns the times at which runs are compared: those at which all were measured. If runs were measured at different
/// times, such as at divisions, times are spaced evenly from the latest beginning to the earliest end.
std::vector<double> timesOf(const std::vector<const std::vector<TimedValue>*>& runs) {
  std::vector<double> times;
  for (const TimedValue& v : *runs.front()) times.push_back(v.time);
  bool alike = true;
  double from = -INFINITY, to = INFINITY;
  for (const auto* run : runs) {
    alike = alike && std::ranges::equal(*run, times, {}, &TimedValue::time);
    from = std::max(from, run->front().time), to = std::min(to, run->back().time);
  }
  if (alike) return times;
  times.clear();
  if (!(from < to)) return times;
  for (int i = 0; i < manyTimes; ++i) times.push_back(from + (to - from) * i / (manyTimes - 1));
  times.back() = to;
  return times;
}

/// Returns the last value measured up to this time.
double valueAt(const std::vector<TimedValue>& values, double time) {
  const auto after = std::ranges::upper_bound(values, time, {}, &TimedValue::time);
  return after == values.begin() ? values.front().value : (after - 1)->value;
}

std::vector<std::size_t> distinctTasks(const StudyResults& r, std::size_t measure, const ResultCondition& condition) {
  std::vector<std::size_t> tasks;
  for (const std::size_t t : condition.tasks)
    if (t != noTask && !r.tasks[t].values[measure].empty() && std::ranges::find(tasks, t) == tasks.end())
      tasks.push_back(t);
  return tasks;
}

}  // namespace

void compareOverTime(StudyComparison& c) {
  const StudyResults& r = c.results;
  for (const std::size_t m : c.measures) {
    std::vector<const std::vector<TimedValue>*> runs;
    bool several = false;
    for (const ResultTask& task : r.tasks) {
      if (task.values[m].empty()) continue;
      runs.push_back(&task.values[m]);
      several = several || task.values[m].size() > 1;
    }
    if (!several) continue;
    const auto times = timesOf(runs);
    for (std::size_t i = 0; i < r.conditions.size(); ++i) {
      const auto tasks = distinctTasks(r, m, r.conditions[i]);
      if (tasks.empty() || times.empty()) continue;
      TimeCourse& course = c.courses.emplace_back(TimeCourse{.measure = m, .condition = i});
      for (const double time : times) {
        std::vector<double> values;
        for (const std::size_t t : tasks) values.push_back(valueAt(r.tasks[t].values[m], time));
        const auto interval = isOnePath(values) ? std::nullopt : intervalOfMean(values);
        course.points.push_back({time, values.size(), mean(values), interval});
      }
    }
  }
}

}  // namespace morula

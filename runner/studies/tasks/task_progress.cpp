#include "tasks/task_progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "system/clock.h"

namespace morula {

TaskProgress::TaskProgress(const Plan& plan, const std::vector<std::size_t>& tasks, int jobs, bool quiet)
    : plan_(plan), jobs_(jobs), begun_(seconds(ClockKind::wall)), line_(quiet), all_(tasks.size()) {
  for (const std::size_t task : tasks) expectedAll_ += expected(task);
}

/// What was predicted; without predictions all tasks count alike.
double TaskProgress::expected(std::size_t task) const {
  return plan_.costs.empty() ? 1 : std::max(plan_.costs[plan_.tasks[task].condition].seconds, 1e-3);
}

void TaskProgress::ended(std::size_t task, bool failed) {
  ++done_;
  if (failed) ++failed_;
  expectedDone_ += expected(task);
}

void TaskProgress::show() {
  if (line_.isDue()) line_.show(text());
}

std::string TaskProgress::text() const {
  const double share = expectedAll_ > 0 ? std::min(expectedDone_ / expectedAll_, 1.0) : 1;
  std::string text = plan_.study.name + line_.bar(share) + fmt::format("  {} of {} runs", done_, all_);
  if (failed_) text += fmt::format("  {} failed", failed_);
  // As fast as so far by the wall clock, whatever else the machine does: what was predicted is off by one and the same factor.
  const double perExpected = expectedDone_ > 0     ? (seconds(ClockKind::wall) - begun_) / expectedDone_
                             : plan_.costs.empty() ? 0
                                                   : 1.0 / jobs_;
  if (perExpected > 0) text += "  " + formatDuration((expectedAll_ - expectedDone_) * perExpected) + " left";
  return text;
}

}  // namespace morula

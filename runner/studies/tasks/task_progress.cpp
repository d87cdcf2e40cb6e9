#include "tasks/task_progress.h"

#include <fmt/format.h>

#include <algorithm>

#include "loop/progress.h"
#include "system/console.h"

namespace morula {

namespace {

using namespace std::chrono_literals;

constexpr int barWidth = 24;

}  // namespace

TaskProgress::TaskProgress(const Plan& plan, const std::vector<std::size_t>& tasks, int jobs, bool quiet)
    : plan_(plan), jobs_(jobs), quiet_(quiet), terminal_(isTerminal()), all_(tasks.size()) {
  for (const std::size_t task : tasks) expectedAll_ += expected(task);
  next_ = Clock::now() + (terminal_ ? 300ms : 30000ms);
}

/// What was predicted; without predictions all tasks count alike.
double TaskProgress::expected(std::size_t task) const {
  return plan_.costs.empty() ? 1 : std::max(plan_.costs[plan_.tasks[task].condition].seconds, 1e-3);
}

void TaskProgress::ended(std::size_t task, double cpuSeconds, bool failed) {
  ++done_;
  if (failed) ++failed_;
  expectedDone_ += expected(task);
  took_ += cpuSeconds;
}

void TaskProgress::show() {
  if (quiet_ || Clock::now() < next_) return;
  showProgress(line());
  shown_ = true;
  next_ = Clock::now() + (terminal_ ? 200ms : 30000ms);
}

void TaskProgress::clear() {
  if (shown_) clearProgress();
  shown_ = false;
}

std::string TaskProgress::line() const {
  const double share = expectedAll_ > 0 ? std::min(expectedDone_ / expectedAll_, 1.0) : 1;
  const int full = static_cast<int>(share * barWidth);
  std::string text = plan_.study.name;
  if (terminal_) text += fmt::format("  [{:=<{}}{:<{}}]", "", full, "", barWidth - full);
  text += fmt::format("  {:.0f} %  {} of {} runs", 100 * share, done_, all_);
  if (failed_) text += fmt::format("  {} failed", failed_);
  // As fast as so far: what was predicted is off by one and the same factor.
  const double perExpected = expectedDone_ > 0 ? took_ / expectedDone_ : plan_.costs.empty() ? 0 : 1;
  if (perExpected > 0)
    text += "  " + formatDuration((expectedAll_ - expectedDone_) * perExpected / jobs_) + " left";
  return text;
}

}  // namespace morula

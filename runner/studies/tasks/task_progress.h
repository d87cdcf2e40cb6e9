#pragma once
// How far a study has come: a bar over its tasks on a terminal, otherwise a line every 30 seconds.
#include <chrono>
#include <string>

#include "study/plan.h"

namespace morula {

class TaskProgress {
 public:
  /// `tasks`: those that are to be computed; `jobs` of them at a time.
  TaskProgress(const Plan& plan, const std::vector<std::size_t>& tasks, int jobs, bool quiet);
  ~TaskProgress() { clear(); }
  TaskProgress(const TaskProgress&) = delete;
  TaskProgress& operator=(const TaskProgress&) = delete;

  /// A task has ended; `cpuSeconds` [s] is what it took.
  void ended(std::size_t task, double cpuSeconds, bool failed);
  /// Shows it if it is time to; call often.
  void show();
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  double expected(std::size_t task) const;
  std::string line() const;

  const Plan& plan_;
  int jobs_;
  bool quiet_, terminal_, shown_ = false;
  std::size_t all_, done_ = 0, failed_ = 0;
  double expectedAll_ = 0, expectedDone_ = 0, took_ = 0;  // [s] of CPU time
  Clock::time_point next_;
};

}  // namespace morula

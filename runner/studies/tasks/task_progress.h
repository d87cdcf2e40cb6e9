#pragma once
// How far a study has come.
#include "study/plan.h"
#include "system/progress_line.h"

namespace morula {

class TaskProgress {
 public:
  /// `tasks`: those that are to be computed; `jobs` of them at a time.
  TaskProgress(const Plan& plan, const std::vector<std::size_t>& tasks, int jobs, bool quiet);

  /// A task has ended.
  void ended(std::size_t task, bool failed);
  /// Shows it if it is time to; call often.
  void show();
  void clear() { line_.clear(); }

 private:
  double expected(std::size_t task) const;
  std::string text() const;

  const Plan& plan_;
  int jobs_;
  double begun_;  // [s] by the wall clock
  ProgressLine line_;
  std::size_t all_, done_ = 0, failed_ = 0;
  double expectedAll_ = 0, expectedDone_ = 0;  // [s] of CPU time
};

}  // namespace morula

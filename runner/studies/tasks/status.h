#pragma once
// The progress of a study, read from the files of its tasks.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tasks/run_study.h"

namespace morula {

struct StudyStatus {
  std::size_t tasks = 0, done = 0;
  std::vector<FailedTask> failed;      // by number
  std::vector<FailedTask> insane;      // done, with an end that is not sane, and why
  std::vector<std::size_t> missing;    // by number
  std::vector<FailedTask> unreadable;  // files that are no results; their tasks are also missing
  std::uint64_t bytes = 0;             // size of all files of the study
  double cpuSeconds = 0;               // [s] CPU time of the results
  // [s] CPU time for missing tasks: the prediction, corrected by the times of finished tasks; without a prediction,
  // their mean. Absent if nothing is known.
  std::optional<double> secondsLeft;
  std::vector<std::string> stale = {};  // sentences on what the study file changes in the plan
  bool isMerged = false;                // study.db exists, and no result is newer

  bool isComplete() const { return missing.empty(); }
  StateCounts counts() const;  // a stale plan counts as one more task
};

/// Reads the state of every task's file, but not damage inside: mergeStudy verifies it.
StudyStatus statusOf(const PlannedStudy& study);

std::string describe(const StudyStatus& status, const PlannedStudy& study);
Json toJson(const StudyStatus& status, const PlannedStudy& study);

}  // namespace morula

#pragma once
// How far a study is, read from the files of its tasks.
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
  std::vector<FailedTask> unreadable;  // files that are no results; their tasks are missing, too
  std::uint64_t bytes = 0;             // of all files of the study
  double cpuSeconds = 0;               // [s] that the results took
  // [s] of CPU time for what is missing: what was predicted, corrected by what the others took; without a prediction as
  // their mean. Absent if nothing is known.
  std::optional<double> secondsLeft;
  std::vector<std::string> stale = {};  // what the study file says otherwise than the plan, a sentence each
  bool isMerged = false;                // study.db is there, and no result is newer

  bool isComplete() const { return missing.empty(); }
  StateCounts counts() const;  // a plan that is stale counts as one more
};

/// Looks at every task's file, but not for damage inside of it: mergeStudy does that.
StudyStatus statusOf(const PlannedStudy& study);

std::string describe(const StudyStatus& status, const PlannedStudy& study);
Json toJson(const StudyStatus& status, const PlannedStudy& study);

}  // namespace morula

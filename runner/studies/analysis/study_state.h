#pragma once
// The states of a merged study's results (golden/result_state.h), and how the verbs of studies report them.
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/study_results.h"
#include "golden/result_state.h"
#include "study/plan_difference.h"

namespace morula {

struct StudyState {
  StateCounts counts;
  AllowedRuns allowed;
  /// [state] A line for each run, or for each difference from the study file.
  std::array<std::vector<std::string>, choices<ResultState>.size()> told;

  ResultState worst() const { return counts.worst(allowed); }
};

/// `difference`: from the present study file, if there is one.
StudyState stateOf(const StudyResults& results, const AllowedRuns& allowed, const PlanDifference& difference = {});

/// Compares the merged study's plan with the study file and its scenarios. Throws StoreError if the plan cannot be
/// read, and the errors of makePlan.
PlanDifference differenceFrom(const std::filesystem::path& database, const Study& now);

/// Returns "runs: 6 fine, 1 not sane, 1 failed; limits allow 0 failed and 0 insane"; "" if all are fine.
std::string countsInWords(const StudyState& state);
/// Returns a line for each run or difference that is not fine, at most 20 of each state, indented.
std::string linesOf(const StudyState& state);
/// Returns {"state": "failed", "states": {…}, "allowed": {"failed": 0, "insane": 0}, "stale": […]}.
Json toJson(const StudyState& state);

/// Returns the states as checks of kind "study", for continuous integration. Messages begin with the study's `file`.
std::vector<CheckResult> checksOf(const StudyState& state, const std::string& file);

}  // namespace morula

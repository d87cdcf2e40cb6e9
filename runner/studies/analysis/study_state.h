#pragma once
// The states of a merged study's results (golden/result_state.h), and what its verbs say and return for them.
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

/// `difference`: from the study file of now, where one is at hand.
StudyState stateOf(const StudyResults& results, const AllowedRuns& allowed, const PlanDifference& difference = {});

/// The merged study's plan beside the study file and its scenarios. Throws StoreError if its plan cannot be read, and
/// what makePlan throws.
PlanDifference differenceFrom(const std::filesystem::path& database, const Study& now);

/// "runs: 6 fine, 1 not sane, 1 failed; limits allow 0 failed and 0 insane"; "" if all are fine.
std::string countsInWords(const StudyState& state);
/// A line for each run or difference that is not fine, at most 20 of each state, indented.
std::string linesOf(const StudyState& state);
/// {"state": "failed", "states": {…}, "allowed": {"failed": 0, "insane": 0}, "stale": […]}.
Json toJson(const StudyState& state);

/// The states as checks of kind "study", for continuous integration. `file`: the study's, with which messages begin.
std::vector<CheckResult> checksOf(const StudyState& state, const std::string& file);

}  // namespace morula

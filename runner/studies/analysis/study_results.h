#pragma once
// The results of a merged study for a comparison: for each condition, seed and measure the values over time.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "system/json.h"

namespace morula {

struct TimedValue {
  double time = 0, value = 0;
};

/// One distinct run.
struct ResultTask {
  std::string id, status;                       // done, failed or missing
  std::string reason;                           // of a failure; of a run that is done, why its end is not sane
  std::string runId;                            // "" while it is missing
  std::string stateHash;                        // of its last state; "" unless done
  std::vector<std::vector<TimedValue>> values;  // [measure] by time; empty: there was nothing to measure
  std::size_t cells = 0;                        // at its end; 0 unless done
  bool isSane = true;                           // the end passed all checks of kind sanity (check_result)

  ResultState state() const;
};

struct ResultAxis {
  std::string name;
  std::vector<std::string> labels;
};

struct ResultCondition {
  std::vector<std::size_t> levels;  // one for each axis
  bool usesSeed = true;
  std::vector<std::size_t> tasks;  // [seed] conditions and seeds that mean the same share them; noTask: not planned
};
inline constexpr std::size_t noTask = std::numeric_limits<std::size_t>::max();

struct StudyResults {
  std::string name, summary;
  std::string buildId;                // of the program that computed all runs; "" if there are none
  AllowedRuns allowed;                // failed and insane runs, by the study file
  std::vector<ResultAxis> axes;       // in the order of the study file, as their levels
  std::vector<std::string> measures;  // those that the study asks for, in its order
  std::vector<std::uint64_t> seeds;   // in rising order
  std::vector<ResultTask> tasks;      // in the order of the plan
  std::vector<ResultCondition> conditions;

  bool isDone(std::size_t task) const;
  /// The value at the end of a run. Absent unless the run is done and had something to measure.
  std::optional<double> end(std::size_t measure, std::size_t task) const;
  /// "longest, none"; "the scenario as it is" without axes.
  std::string nameOf(const ResultCondition& condition) const;
  StateCounts counts() const;  // of all tasks
};

/// A run that failed, is missing or is not sane, and the first condition and seed that it is of.
struct TroubledRun {
  std::string condition;
  std::uint64_t seed;
  const ResultTask& task;
};
std::vector<TroubledRun> troubledRuns(const StudyResults& results);
/// The names of conditions that have the same runs.
std::vector<std::vector<std::string>> namesOfSameRuns(const StudyResults& results);

/// Throws StoreError (exit 6) if the file is none that `morula study merge` has made.
StudyResults readStudyResults(const std::filesystem::path& file);

/// Throws StoreError if the database is a merged study, and the rows of its own tables are not those that were stored.
void requireIntactStudy(const std::filesystem::path& file);

/// Hands on the plan that a merged study holds. Throws StoreError if it cannot be read, or where `read` finds it to be
/// none.
void readStoredPlan(const std::filesystem::path& file, const std::function<void(const Json& plan)>& read);

}  // namespace morula

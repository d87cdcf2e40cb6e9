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
#include "study_store/study_tables.h"
#include "system/json.h"

namespace morula {

struct TimedValue {
  double time = 0, value = 0;
};

/// One distinct run.
struct ResultTask {
  std::string id;
  TaskStatus status = TaskStatus::missing;
  std::string reason;                           // why the run failed; of a run that is done, why its end is not sane
  std::string runId;                            // "" if missing
  std::string stateHash;                        // hash of the last state; "" unless done
  std::vector<std::vector<TimedValue>> values;  // [measure] by time; empty: there was nothing to measure
  std::size_t cells = 0;                        // at the end; 0 unless done
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
  std::vector<std::size_t> tasks;  // [seed] equal conditions and seeds share tasks; noTask: not planned
};
inline constexpr std::size_t noTask = std::numeric_limits<std::size_t>::max();

struct StudyResults {
  std::string name, summary;
  std::string buildId;                // build of the program that computed all runs; "" without runs
  AllowedRuns allowed;                // failed and insane runs, by the study file
  std::vector<ResultAxis> axes;       // in the order of the study file and of levels
  std::vector<std::string> measures;  // the measures that the study asks for, in its order
  std::vector<std::uint64_t> seeds;   // in rising order
  std::vector<ResultTask> tasks;      // in the order of the plan
  std::vector<ResultCondition> conditions;

  bool isDone(std::size_t task) const;
  /// Returns the value at the end of a run. Absent unless the run is done and had something to measure.
  std::optional<double> end(std::size_t measure, std::size_t task) const;
  /// Returns "longest, none"; "the scenario as it is" without axes.
  std::string nameOf(const ResultCondition& condition) const;
  StateCounts counts() const;  // states of all tasks
};

/// A run that failed, is missing or is not sane, with its first condition and seed.
struct TroubledRun {
  std::string condition;
  std::uint64_t seed;
  const ResultTask& task;
};
std::vector<TroubledRun> troubledRuns(const StudyResults& results);
/// Returns the names of conditions that have the same runs, in groups.
std::vector<std::vector<std::string>> namesOfSameRuns(const StudyResults& results);

/// Throws StoreError (exit 6) if the file was not made by `morula study merge`.
StudyResults readStudyResults(const std::filesystem::path& file);

/// Throws StoreError if the database is a merged study whose own tables have changed since they were stored.
void requireIntactStudy(const std::filesystem::path& file);

/// Hands the stored plan of a merged study to `read`. Throws StoreError if the plan cannot be read, or if `read` finds
/// it invalid.
void readStoredPlan(const std::filesystem::path& file, const std::function<void(const Json& plan)>& read);

}  // namespace morula

#pragma once
// The tables of a study: `task`, `result` and `timing` stand in the file of one task and in the merged file; `study`, `axis`,
// `level`, `condition`, `condition_key` and `replicate` in the merged file alone. study_store/README.md describes their columns.
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/hash.h"
#include "database/database.h"

namespace morula {

/// Why a task has no state hash. The row's `reason` begins with the name of its kind, a colon and a blank.
enum class FailureKind {
  numerical,  // of the computation itself: the same everywhere
  cpuLimit,
  memoryLimit,
  crash,
};
const char* name(FailureKind kind);

struct TaskRow {
  std::string id;
  std::uint64_t number = 0, condition = 0, seed = 0;  // in the plan
  std::string status = "missing";                     // done, failed, missing
  std::string reason = {};                            // of a failure; "" otherwise
  std::string runId = {}, resultHash = {};            // "" while it is missing

  /// It is done, or failed numerically: that follows from scene, seed and program alone. Limits and crashes depend on the
  /// machine, too.
  bool isComputed() const;
};

/// One value of one measure of a run: a scalar.
struct ResultRow {
  std::string measure;
  double time = 0;  // [time]
  double value = 0;
  friend bool operator==(const ResultRow&, const ResultRow&) = default;
};

/// When and where a task was computed: all that may differ between two runs of the same task.
struct TimingRow {
  std::string started, ended;   // UTC
  double cpuSeconds = 0;        // [s]
  std::uint64_t maxMemory = 0;  // [byte]
  std::string host, cpu, kernel, cpuFeatures, fpEnvironment, isa;
  int threads = 1;
  std::string command, binaryHash;
};

/// Makes `task`, `result` and `timing`.
void makeTaskTables(Database& db);
/// Makes the others. `axes`, `keys`: columns of `condition` and `condition_key`.
void makeStudyTables(Database& db, const std::vector<std::string>& axes,
                     const std::vector<std::string>& keys);

void insertTask(Database& db, const TaskRow& task);
void insertResults(Database& db, const std::string& run, const std::vector<ResultRow>& results);
void insertTiming(Database& db, const std::string& task, const TimingRow& timing);

/// All tables that hold results of a run, the measures' `result` among them, in the order in which they can be filled.
const std::vector<std::string>& tablesOfResults();

/// Over how the run ended and all rows of its results: what must be the same wherever the task is computed. Columns that
/// are NULL do not count, so that a later version of the tables finds the same hash.
Hash resultHash(Database& db, const std::string& run);

/// "name" for SQL, whatever stands in it.
std::string quotedName(const std::string& name);

}  // namespace morula

#pragma once
// The file of one task of a study: a Morula database of one run, with the task's own tables beside it.
#include <filesystem>
#include <string>
#include <vector>

#include "store/records.h"
#include "store/store.h"
#include "study_store/study_tables.h"

namespace morula {

/// A task that has been computed, or has failed.
struct TaskOutcome {
  TaskRow task;  // with id, number, condition and seed; the rest is filled in
  RunRecord record;
  RunEnd end;          // done or failed
  RunResults results;  // the part that is kept
  std::vector<ResultRow> values;
  TimingRow timing;
};

/// Returns an empty task's file, from which all others are made. Call once before starting the processes of tasks.
const std::string& emptyTaskFile();

/// Returns the bytes of the task's file. They are made in memory, so that writing them takes one synchronisation.
std::string taskFileBytes(TaskOutcome outcome);

/// The file of a task, read into memory.
class TaskFile {
 public:
  /// Throws FileError if the file cannot be read, is no database of this version of Morula, or holds no task.
  explicit TaskFile(const std::filesystem::path& file);

  const TaskRow& task() const { return task_; }
  const StoredRun& run() const { return run_; }
  TimingRow timing();
  std::string buildId();
  /// Returns the scenario of the run with all values filled in; "" if none is stored.
  std::string resolved();
  /// Returns why the end of the run is not sane [morula::whyInsane]; "" if it is, or there is no end.
  std::string whyInsane();

  /// Returns the mistake in the file, in the database's structure or in ids and hashes that do not match their content;
  /// "" if there is none.
  std::string whatIsWrong();

 private:
  friend class MergedStudy;
  Database& db() { return store_.db_; }
  Store store_;
  TaskRow task_;
  StoredRun run_;
};

/// Returns true if the file is as long as its header says and begins as a database does. This is quick, and enough for
/// files that were renamed once they were complete; whatIsWrong checks their content.
bool looksWhole(const std::filesystem::path& file);

}  // namespace morula

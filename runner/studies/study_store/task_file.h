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
  TaskRow task;  // id, number, condition and seed; the rest follows
  RunRecord record;
  RunEnd end;          // done or failed
  RunResults results;  // what is kept of them
  std::vector<ResultRow> values;
  TimingRow timing;
};

/// An empty task's file, from which all others are made: call it once before processes of their own fill one each.
const std::string& emptyTaskFile();

/// The bytes of the task's file. Made in memory, so that writing them takes one synchronisation.
std::string taskFileBytes(TaskOutcome outcome);

/// A task's file, read into memory.
class TaskFile {
 public:
  /// Throws FileError: it cannot be read, is no database, none of Morula's or of another version, or holds no task.
  explicit TaskFile(const std::filesystem::path& file);

  const TaskRow& task() const { return task_; }
  const StoredRun& run() const { return run_; }
  TimingRow timing();
  std::string buildId();
  /// The scenario of its run with all values filled in; "" if it is not stored.
  std::string resolved();
  /// Why the end of its run is not sane [morula::whyInsane]; "" if it is, or there is no end.
  std::string whyInsane();

  /// Returns the mistake in the file: in the database's structure, or ids and hashes that do not follow from its
  /// content; "" if there is none.
  std::string whatIsWrong();

 private:
  friend class MergedStudy;
  Database& db() { return store_.db_; }
  Store store_;
  TaskRow task_;
  StoredRun run_;
};

/// Returns true if the file is as long as its header says and begins as a database does. That is quick, and enough for
/// files that were renamed once they were complete; whatIsWrong checks their content.
bool looksWhole(const std::filesystem::path& file);

}  // namespace morula

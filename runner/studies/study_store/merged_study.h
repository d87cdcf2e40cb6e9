#pragma once
// The merged database of a study: all its runs in one file, made anew from the files of the tasks. Equal tasks, added
// in equal order, make equal bytes, but for the table `timing`.
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "files/draft.h"
#include "study_store/task_file.h"

namespace morula {

/// The plan of a study as rows.
struct StudyTables {
  StudyRow study;  // without its build
  std::vector<AxisRow> axes = {};
  std::vector<LevelRow> levels = {};
  std::vector<std::string> keys = {};  // columns of condition_key
  struct ConditionRow {
    std::vector<std::string> labels;  // one for each axis
    bool usesSeed = false;
    std::uint64_t distinctRuns = 0;
    std::vector<std::optional<std::string>> keyValues = {};  // one for each of `keys`
  };
  std::vector<ConditionRow> conditions = {};  // by number
  std::vector<ReplicateRow> replicates = {};
};

class MergedStudy {
 public:
  /// Begins a draft that replaces `file` when it is finished. Throws FileError.
  MergedStudy(const std::filesystem::path& file, const StudyTables& study);

  /// Adds a task and its run. The plan gives `number`, `condition` and `seed`.
  void add(const TaskRow& planned, TaskFile& file);
  void addMissing(const TaskRow& planned);

  /// Finishes the file. All tasks must have been added.
  void finish(const StudyTables& study, const std::string& buildId);

 private:
  struct Copy {
    std::string select;
    Statement insert;
    bool isOfTask;  // selected by task, not by run
  };
  Draft draft_;
  Database db_;
  std::vector<Copy> copies_;
  std::set<std::string> runs_;  // runs whose rows are stored
};

}  // namespace morula

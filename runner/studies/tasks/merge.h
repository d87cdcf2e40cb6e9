#pragma once
// The results of all tasks in one database, on whatever machine they were computed and wherever their files lie.
#include <filesystem>
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "system/json.h"
#include "tasks/run_study.h"

namespace morula {

struct MergeOptions {
  /// Folders of studies, folders of tasks' files, and tasks' files, besides the study's own.
  std::vector<std::string> shards;
  std::filesystem::path output;
};

/// A file that was left out, and why.
struct RefusedFile {
  std::filesystem::path file;
  std::string why;
};

/// Two files of one task whose results differ.
struct Nondeterminism {
  std::size_t task = 0;
  std::filesystem::path a, b;
  std::string hashA, hashB;
};

struct MergeReport {
  std::filesystem::path database;
  std::size_t tasks = 0, done = 0;
  std::vector<FailedTask> failed;    // their results, by number
  std::vector<std::size_t> missing;  // by number
  std::vector<FailedTask> insane;    // done, but with an end that is not sane, and why (check_result, kind sanity)
  std::vector<RefusedFile> damaged;
  std::vector<RefusedFile> foreign;       // of tasks that the plan does not have
  std::vector<Nondeterminism> differing;  // then nothing is written
  double seconds = 0;                     // [s]
  std::uint64_t bytes = 0;                // of the database

  /// Counts the states of tasks; a file that was left out counts as one more, which is changed.
  StateCounts counts() const;
};

/// Verifies every file, its structure, ids and hashes, and puts the database together anew: the same results give the
/// same bytes, in whatever order and from however many places they come. Files that cannot be right are left out and
/// reported. Writes nothing if two files of one task differ. Throws FileError if a shard cannot be read, or if they
/// come from several builds.
MergeReport mergeStudy(const PlannedStudy& study, const MergeOptions& options);

std::string describe(const MergeReport& report, const PlannedStudy& study);
Json toJson(const MergeReport& report, const PlannedStudy& study);

}  // namespace morula

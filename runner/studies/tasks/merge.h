#pragma once
// Merges the results of all tasks into one database, on whatever machines they were computed.
#include <filesystem>
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "system/json.h"
#include "tasks/run_study.h"

namespace morula {

struct MergeOptions {
  /// Folders of studies, folders of tasks' files, and tasks' files, besides the study's own folder.
  std::vector<std::string> shards;
  std::filesystem::path output;
};

/// A file that was left out, and the reason.
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
  std::vector<FailedTask> failed;    // with results, by number
  std::vector<std::size_t> missing;  // by number
  std::vector<FailedTask> insane;    // done, but with an end that is not sane, and why (check_result, kind sanity)
  std::vector<RefusedFile> damaged;
  std::vector<RefusedFile> foreign;       // files of tasks that the plan does not have
  std::vector<Nondeterminism> differing;  // if any, nothing is written
  double seconds = 0;                     // [s]
  std::uint64_t bytes = 0;                // size of the database

  /// Counts the states of tasks; a file that was left out counts as one more task, in the state `changed`.
  StateCounts counts() const;
};

/// Verifies structure, ids and hashes of every file, and makes the database anew. Equal results give equal bytes,
/// whatever the order and the places of their files. Invalid files are left out and reported. Writes nothing if two
/// files of one task differ. Throws FileError if a shard cannot be read, or if files come from several builds.
MergeReport mergeStudy(const PlannedStudy& study, const MergeOptions& options);

std::string describe(const MergeReport& report, const PlannedStudy& study);
Json toJson(const MergeReport& report, const PlannedStudy& study);

}  // namespace morula

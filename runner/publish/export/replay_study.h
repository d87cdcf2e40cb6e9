#pragma once
// A crate of a study once more: some of its runs from the study file, and what follows from the values of all.
#include <filesystem>
#include <string>
#include <vector>

#include "system/json.h"
#include "tasks/run_task.h"

namespace morula {

struct StudyReplay {
  struct Run {
    std::string name, then, now;            // condition and seed; hashes of the final state, "" if the run did not end
    std::uint64_t rows = 0, differing = 0;  // of all tables of results, and of the study's values
    bool isSame() const { return then == now && differing == 0; }
  };
  std::string study, buildThen, buildNow;
  std::size_t files = 0;             // number of files whose bytes have been compared with the metadata
  std::vector<std::string> changed;  // a line for each file that is not the one of the metadata
  std::vector<std::string> plan;     // a line for each difference between the study file and the stored plan
  std::vector<Run> runs;
  std::vector<std::pair<std::string, bool>>
      derived;  // each file that follows from the values, and if its bytes are the same

  bool sameBytes() const;
};

/// Repeats `count` of the runs that are done, evenly over the plan, and the comparison. Requires that the process has one
/// thread. Throws FileError if the folder is no crate of a study.
StudyReplay replayStudy(const std::filesystem::path& crate, std::size_t count, const TaskSettings& settings);

std::string describe(const StudyReplay& replay);
Json toJson(const StudyReplay& replay);

}  // namespace morula

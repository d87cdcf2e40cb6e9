#pragma once
// One page of runs, studies, checks or accuracy runs: from their files to the page's bytes.
#include <string>
#include <vector>

#include "golden/check_result.h"
#include "simulation/world.h"

namespace morula {

struct ReportQuestion {
  std::vector<std::string>
      what;  // databases of runs and of merged studies, report.json of checks, output of accuracy --json, or folders of these
  std::string run;  // only the run with this id, or whose id begins so; of a study also "CONDITION, seed N"; "": all
  std::size_t explored = 24;          // runs of studies that are shown in three dimensions, where they fit
  std::size_t frames = 100;           // of each run that is shown in three dimensions; 0: no run is made again
  std::size_t maxBytes = 10'000'000;  // of the page
  std::string program;                // the explorer's; "": without it
  std::string whyNone;                // why there is none; plain text
  bool rerun = false;                 // the page holds the simulator, too, and makes its run again
  std::string module;                 // the simulator, gzipped; of rerun
  Execution execution;
  bool bullet = true;  // beside ours, where scenarios have check.bullet and frames are asked for
  bool quiet = false;
};

struct ReportAnswer {
  std::string bytes;  // of the page
  std::size_t runs = 0;
  std::vector<std::string> remarks;  // what was left out, for people
};

/// Takes the explorer's program from beside the running one, where ./morula builds it, or says why there is none. Of a
/// page that runs again also the simulator; throws FileError where one of the two is not there.
void findExplorer(ReportQuestion& question);

/// Throws UsageError for what is nothing to report on, FileError, InputError, Interrupted.
ReportAnswer makeReport(const ReportQuestion& question);

/// Runs that are shown in three dimensions at most, but of studies; the explorer shows two of them side by side. Of a
/// study also those that stand for its conditions in pictures and charts.
inline constexpr std::size_t maxExplored = 4;
/// Runs that are made again in Bullet at most.
inline constexpr std::size_t maxInBullet = 2;

}  // namespace morula

#pragma once
// One page of runs, studies, checks or accuracy runs: from their files to the page's bytes.
#include <string>
#include <vector>

#include "golden/check_result.h"
#include "simulation/simulation.h"

namespace morula {

struct ReportQuestion {
  std::vector<std::string>
      what;  // databases of runs and merged studies, report.json of checks, output of accuracy --json, or their folders
  std::string run;  // only the run of this id or beginning of one; of a study also "CONDITION, seed N"; "": all
  std::size_t explored = 24;          // max number of a study's runs that are shown in three dimensions, if they fit
  std::size_t frames = 100;           // frames of each run in three dimensions; 0: no run is simulated again
  std::size_t maxBytes = 4'000'000;   // max size of the page
  std::string program;                // the explorer's program; "": without the explorer
  std::string whyNone;                // the reason for a missing explorer; plain text
  bool rerun = false;                 // true: the page also holds the simulator, and repeats its run
  std::string module;                 // the simulator for `rerun`, gzipped
  Execution execution;
  bool bullet = true;  // true: also runs scenarios with check.bullet in Bullet, if there are frames
  bool quiet = false;
};

struct ReportAnswer {
  std::string bytes;  // the page
  std::size_t runs = 0;
  std::vector<std::string> remarks;  // what was left out, for people
};

/// Finds the explorer's program beside the running program, where ./morula builds it, or tells why it is missing. A
/// page that repeats its run also needs the simulator; then throws FileError if either is missing.
void findExplorer(ReportQuestion& question);

/// Throws UsageError for what is nothing to report on, FileError, InputError, Interrupted.
ReportAnswer makeReport(const ReportQuestion& question);

/// Max number of runs in three dimensions, but for studies; the explorer shows two of them side by side. Also the
/// number of a study's runs that represent its conditions in pictures and charts.
inline constexpr std::size_t maxExplored = 4;
/// Max number of runs that are simulated in Bullet.
inline constexpr std::size_t maxInBullet = 2;

}  // namespace morula

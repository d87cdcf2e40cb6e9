#pragma once
// The runs of a page that are simulated again and shown in three dimensions.
#include "report/page_parts.h"

namespace morula {

struct Explored {
  std::vector<ExplorerRun> runs;  // at most maxExplored
  std::vector<Frames*> frames;    // frames of the runs that were simulated again
};

/// Min number of frames of each run of a study; it limits how many runs fit.
inline constexpr std::size_t minFrames = 11;

/// Adds the failed scenarios of a check that were run again, each before its run in Bullet.
void exploreChecked(std::vector<CheckedScenario>& checked, Explored& explored);

/// Makes runs again, up to what there is room for, and some in Bullet, which stand behind ours. Where none is made
/// again, their trees are shown.
void exploreRuns(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

/// Makes runs of studies again until their frames would fill the page.
void exploreMore(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

}  // namespace morula

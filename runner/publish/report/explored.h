#pragma once
// The runs of a page that are made again and shown in three dimensions.
#include "report/parts.h"

namespace morula {

struct Explored {
  std::vector<ExplorerRun> runs;  // at most maxExplored
  std::vector<Frames*> frames;    // of those that were made again
};

/// Frames that each run of a study keeps at least; how many runs have room follows from it.
inline constexpr std::size_t minFrames = 11;

/// The failed scenarios of a check that were run again, each before its run in Bullet.
void exploreChecked(std::vector<CheckedScenario>& checked, Explored& explored);

/// Makes runs again, up to what there is room for, and some in Bullet, which stand behind ours. Where none is made
/// again, their trees are shown.
void exploreRuns(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

/// Makes runs of studies again until their frames would fill the page.
void exploreMore(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

}  // namespace morula

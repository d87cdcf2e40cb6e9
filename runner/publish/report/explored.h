#pragma once
// The runs of a page that are simulated again and shown in three dimensions.
#include "report/parts.h"

namespace morula {

struct Explored {
  std::vector<ExplorerRun> runs;  // at most maxExplored
  std::vector<Frames*> frames;    // frames of the runs that were simulated again
};

/// Min number of frames of each run of a study; it limits how many runs fit.
inline constexpr std::size_t minFrames = 11;

/// Adds the failed scenarios of a check that were run again, each before its run in Bullet.
void exploreChecked(std::vector<CheckedScenario>& checked, Explored& explored);

/// Simulates runs again, as many as fit, and some in Bullet, which come after Morula's. If none is simulated again
/// their trees are shown. Returns the signal that interrupted it, or 0.
int exploreRuns(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

/// Simulates runs of studies again until their frames fill the page. Returns the interrupting signal, or 0.
int exploreMore(std::vector<RunFacts>& runs, const ReportQuestion& question, Explored& explored);

}  // namespace morula

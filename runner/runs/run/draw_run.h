#pragma once
// The pictures of a run that has come to its end, and what needs them: beside its golden, beside Bullet.
#include "loop/simulate.h"
#include "pictures/pictures.h"
#include "run/run_scenario.h"
#include "store/store.h"

namespace morula {

/// Draws the end and the sequence, and compares with the golden and with Bullet where the scenario asks for it; adds
/// pictures and checks to `outcome`. Called after the run is stored, so that a failure loses nothing.
void drawRun(const Scenario& scenario, const RunSettings& settings, const Simulation& run, FrameCollector& frames,
             Store& store, RunOutcome& outcome);

}  // namespace morula

#pragma once
// The loop: step until the scene's end, a failure or a signal.
#include <functional>
#include <optional>

#include "cli/progress.h"
#include "scenario/scenario.h"
#include "simulation/world.h"
#include "store/recorder.h"

namespace morula::cli {

struct Simulation {
  World world;
  RunEnd end;          // done, failed or killed
  RunResults results;  // lineage, samples, step hashes, …
  int signal = 0;      // the one that ended it
};

/// Builds the scenario's world. InputErrors name the scenario's file.
World makeScenarioWorld(const Scenario& scenario, const Execution& execution);

/// What a run of the scenario writes down: its samples, and hashes of the states on the way if somebody looks
/// at them.
RecordOptions recordingOf(const Scenario& scenario, bool hashes);

/// Runs it and writes down what `record` says. `watch`, if given, sees the world at the start and after every
/// step. A NumericalError is not thrown but told in `end.failure`.
Simulation simulate(World world, const RecordOptions& record, Progress& progress,
                    const std::function<void(const World&)>& watch = {});

}  // namespace morula::cli

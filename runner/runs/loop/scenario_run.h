#pragma once
// From a scenario to its run: the world, the record of what decides the run, what the run records.
#include <string>

#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "store/recorder.h"
#include "store/records.h"

namespace morula {

/// Builds the scenario's world. InputErrors name the scenario's file.
World makeScenarioWorld(const Scenario& scenario, const Execution& execution);

/// [steps] from one hash of the state to the next, where the states on the way are hashed. Enough to tell at which step
/// two runs part; a hash costs about as much as a step.
constexpr std::uint64_t stepsPerHash = 64;
/// Returns the number of steps between two hashes: 1 in scenes whose steps are cell cycles or settlings.
std::uint64_t stepsPerHashOf(const Scene& scene);

/// Returns true if a checked run hashes the states on the way: for the comparison with a golden, or as `check` asks.
/// `explain --db` looks for the first difference in the hashes that are stored.
bool wantsHashes(const Scenario& scenario, bool hasGolden);

/// Another way to compute the same: other kernels and another number of threads.
Execution otherExecution(const Execution& how);

/// Makes the part of a run's record that is known before its first step. `command`: as typed.
RunRecord recordOf(const Scenario& scenario, const Execution& execution, const std::string& command);

/// Returns what a run of the scenario records: its samples, and with `hashes` the hashes of states on the way.
RecordOptions recordingOf(const Scenario& scenario, bool hashes);

}  // namespace morula

#pragma once
// The scenario that accuracy examines: its variants, the times that it reaches, and the origin of what is measured.
#include "accuracy/trial.h"
#include "system/json.h"

namespace morula {

/// Makes a reader of the scenario with `overrides` and further changes, which replace overrides of the same path.
/// Changed scenarios have no checks and record no measures, since these may not fit them.
ReadScenario variantsOf(std::string file, std::vector<Override> overrides, bool allowOutside);

/// Returns the time [time] after so many steps, at the scene's end, or at `latest`, whichever comes first.
double timeReached(World world, std::uint64_t steps, double latest);

/// Throws UsageError, which names --until, if the scene ends before `until` [time]. A scene that fails on the way does
/// not end.
void requireWithinScene(World world, double until);

/// Returns the origin of measured numbers, since seconds of CPU time belong to one machine. `command`: the command line
/// as typed.
Json originOf(const Scenario& scenario, const Execution& execution, const std::string& command);

}  // namespace morula

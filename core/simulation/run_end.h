#pragma once
// When a run ends, and how many steps lead there.
#include <cstdint>

#include "state/world.h"

namespace morula {

/// Returns what the clock shows [time] `steps` steps from now.
double timeAfter(const Clock& clock, std::uint64_t steps);

/// True if `steps` steps of the clock's length lead past the planned end.
bool endsLate(const World& world, std::uint64_t steps);

/// Returns the next step's length [time]: the clock's time step, or with an automatic one what is left until the
/// planned end, if that is less. Requires bodies.
double nextStepLength(const World& world);

/// Returns the time [time] from which on the planned end counts as reached; infinite without one. Requires bodies.
double plannedStop(const World& world);

/// True once as many cells live as the scene stops at.
bool hasEnoughCells(const World& world);

/// Returns until when [time] cell cycles run in a step from `before` to the clock's time: until the clock's time, or in
/// the step that reaches the planned end, until that end. Later cycles do not run, as they would not without bodies.
double dueUntil(const World& world, double before);

}  // namespace morula

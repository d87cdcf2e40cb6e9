#pragma once
// The biological part of a step: cell cycles, and the events that follow from them.
#include "state/world.h"

namespace morula {

/// Runs the cell cycles that are due up to `until` [time], and the deaths, divisions and connections that follow from
/// them. Cycles run in the order in which they are due, cycles due at the same time together; none runs after the one
/// that gives the scene as many cells as it stops at. A cell that does not want its cycle yet is asked again in each
/// step, together with those whose cycles are due at the step's end. `before`: the clock's time before this step.
void runCellCycles(World& world, double before, double until);

/// Runs cell cycles as runCellCycles, and the experiments that are due until then [time], each after the cycles that
/// were due before it.
void runEvents(World& world, double before, double until);

}  // namespace morula

#pragma once
// The functions that make a world of a scene and take it on.
#include <cstdint>
#include <memory>

#include "state/world.h"

namespace morula {

/// Builds the world at time 0: one egg, or the scene's start cells. Throws InputError if the scene cannot
/// run, for example when its fixed time step lies above the stability limit, which the text names.
World makeWorld(const Scene& scene, const Execution& execution = {});

/// Makes a world whose cells are controlled by another biology than the scene's DNA.
World makeWorld(const Scene& scene, std::unique_ptr<BiologicalUnit> biology, const Execution& execution);

/// Takes one time step, or in a lineage-only or quasi-static world goes to the next cell cycle, and does the divisions,
/// deaths and connections that are due; a quasi-static world settles then. Throws NumericalError when the physics
/// cannot go on; the world then holds the failed state.
void step(World& world);

/// Takes up to `most` steps, but not past a cell cycle or the planned end: the same as that many calls of step.
/// Isolated cells make all of these steps block by block.
void takeSteps(World& world, std::uint64_t most);

/// Returns the number of steps until the clock shows `time` [time] or later; 1 at least.
std::uint64_t stepsUntil(const Clock& clock, double time);

/// True once one of the scene's stop conditions holds.
bool finished(const World& world);

}  // namespace morula

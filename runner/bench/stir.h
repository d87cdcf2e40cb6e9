#pragma once
// Keeps a packed world moving, so that it is timed as a living organism, whose searches for neighbours fall due.
#include "simulation/world.h"

namespace morula {

/// [edges] Root mean square way of a vertex in one step. An organism that divides moves ten times as fast for
/// a moment and slower for most of a cycle.
constexpr double stirredMove = 6e-4;
constexpr int stirEvery = 32;  // [steps]

/// Gives every cell a push of its own in a random direction, then scales all velocities so that vertices move
/// by `stirredMove` per step. The same pushes for the same step, whoever asks.
void stir(World& world);

}  // namespace morula

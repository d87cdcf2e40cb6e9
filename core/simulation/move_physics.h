#pragma once
// The physical stages of a step: growth, motion, and every force at the new positions.
#include <cstddef>

#include "state/world.h"

namespace morula {

/// Moves all cells on by `timeStep` and evaluates every force at the new positions.
void movePhysics(World& world, double timeStep);

/// Evaluates every force where the cells are; nothing moves.
void evaluateForces(World& world);

/// Makes one of the evaluations of a time step, with what comes before and after it. A time step of 0 moves nothing.
void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep);

/// Cells that grow or shrink. Returns at once where the scene has no growth.
void growCells(World& world, double timeStep);

}  // namespace morula

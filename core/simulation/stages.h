#pragma once
// The stages of a step that concern the whole world; step.cpp calls them in order.
#include <cstdint>

#include "simulation/world.h"

namespace morula {

/// [time] What the clock shows so many steps from now.
double timeAfter(const Clock& clock, std::uint64_t steps);

/// [time] What the clock shows, or more, once the planned end has come; infinite without one. The world has
/// bodies.
double plannedStop(const World& world);

/// Moves all cells on by `timeStep` and evaluates every force at the new positions; 0 only evaluates.
void movePhysics(World& world, double timeStep);

/// The part of it that evaluation number `evaluation` of the forces takes.
void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep);

/// Sets the world's kernels to those of an instruction set. It has bodies.
void setStages(World& world, Isa isa);

/// Throws NumericalError if a cell's volume is not a positive number below the largest sensible one.
void checkBodies(const World& world);

/// Throws NumericalError if a vertex has moved farther in this step than its contacts reach: cells could then
/// pass through each other and never have touched. To be called with all snapshots, before the list follows.
void checkReach(const World& world);

/// Cells that grow or shrink. Returns at once where the scene has no growth.
void growCells(World& world, double timeStep);

/// Runs the cell cycles that are due, then the deaths, divisions and connections that follow from them.
void runCellCycles(World& world);

/// Ends connections whose cells are too far apart. Returns at once where there are none.
void releaseConnections(World& world);

/// [time] Up to which a time step is stable for the cells as they are, with some margin; an automatic one is
/// the power of two below. Needs at least one cell.
double timeStepLimit(const World& world);

/// Sets the time step for the cells as they are now: the scene's own, or the largest dyadic one that is
/// stable, and evaluates the forces for it if it has changed. Throws NumericalError if the scene's own lies
/// above 0.8 of a stability limit, which the text names.
void chooseTimeStep(World& world);

}  // namespace morula

#pragma once
// The stages of a step that concern the whole world; step.cpp calls them in order.
#include <cstdint>
#include <span>

#include "simulation/world.h"

namespace morula {

/// [time] What the clock shows so many steps from now.
double timeAfter(const Clock& clock, std::uint64_t steps);

/// True if so many steps of the clock's length lead past the planned end.
bool endsLate(const World& world, std::uint64_t steps);

/// [time] The next step's length: the clock's time step, or where the scene leaves it to the program and the
/// planned end comes sooner, what is left until then. The world has bodies.
double nextStepLength(const World& world);

/// [time] What the clock shows, or more, once the planned end has come; infinite without one. The world has
/// bodies.
double plannedStop(const World& world);

/// Moves all cells on by `timeStep` and evaluates every force at the new positions.
void movePhysics(World& world, double timeStep);

/// Evaluates every force where the cells are; nothing moves.
void evaluateForces(World& world);

/// One of the evaluations of a time step, and what comes before and after it. With a time step of 0 nothing
/// moves.
void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep);

/// Sets the world's kernels to those of an instruction set. It has bodies.
void setStages(World& world, Isa isa);

/// Throws NumericalError if a cell's volume is not a positive number below the largest sensible one.
void checkBodies(const World& world);

/// Throws BodyFailure if a cell begins deeper in another one than contacts reach: no force would part the two. Cost:
/// for each pair of cells whose bounding boxes overlap that deep, the vertices of one times the faces of the other.
void checkStart(const World& world);

/// Throws NumericalError if one of these numbers of a cell's state is not finite. The step itself looks at volumes
/// alone: what they do not show yet, the next step brings into them.
void checkNumbers(const World& world, std::size_t cell, const char* field, std::span<const double> values);
/// All numbers of all cells' bodies.
void checkNumbers(const World& world);

/// Throws NumericalError if a vertex has moved farther in this step than its contacts reach: cells could then
/// pass through each other and never have touched. To be called with all snapshots, before the list follows.
void checkReach(const World& world);

/// Throws BodyFailure if a cell in flight has more of its volume in another one than sanity allows: cells that meet at
/// high speed crumple, and where vertices slip between vertices, none is seen deep. Looks every 4 steps, and only while
/// contacts are pressed hard.
void checkCrossing(const World& world);

/// Cells that grow or shrink. Returns at once where the scene has no growth.
void growCells(World& world, double timeStep);

/// Tells contacts which cells stick to others alike, by their substances, and what the seed varies. Returns at
/// once where adhesion depends on neither.
void sortByAdhesion(World& world);

/// Runs the cell cycles that are due until then [time], and the deaths, divisions and connections that follow
/// from them. Cycles run in the order in which they are due, and those that are due at the same time
/// together; none runs after the one that gives the scene as many cells as it stops at. A cell that does not want
/// its cycle yet is asked again in each step, together with those whose cycles are due at the step's end. `before`:
/// the clock's time before this step.
void runCellCycles(World& world, double before, double until);

/// Runs cell cycles as runCellCycles, and the experiments that are due until then [time], each after the cycles that
/// were due before it.
void runEvents(World& world, double before, double until);

/// [time] The longest cycle that a cell of a scene may have, without what the seed varies.
double longestCycle(const CycleParameters& cycle);

/// [1] A cell's cycle lengths over those of its state: 1 ± variation.cycle, times what experiments say.
double paceOf(const World& world, const CellPath& path, StateId state);

/// [time] When the next cycle of living cell number `cell` is due.
double nextCycleOf(const World& world, std::size_t cell);

/// True once as many cells live as the scene stops at.
bool hasEnoughCells(const World& world);

/// [time] Until when cell cycles run in a step that goes from `before` to the clock's time: the clock's time,
/// or in the step that reaches the planned end, that end: what is due later does not run, as it would not
/// without bodies.
double dueUntil(const World& world, double before);

/// Ends connections whose cells are too far apart, that pull too hard or are too old. Returns at once where there are
/// none.
void releaseConnections(World& world);

/// [time] Up to which a time step is stable for the cells as they are, with some margin; an automatic one is
/// the power of two below. Needs at least one cell.
double timeStepLimit(const World& world);

/// [time] An automatic time step where steps up to `limit` are stable: the largest power of two that is no longer than
/// this and than the shortest cell cycle that the scene may bring, so that no cell has more than one cycle in a step.
double automaticTimeStep(const Scene& scene, double limit);

/// Throws InputError if more cell cycles would come one after the other than any run can make, or if one
/// cycle is so much shorter than another that times cannot tell its beginning from its end.
void refuseEndlessPace(const Scene& scene);

/// Gives each cell the inertia with which a time step of 1 is 0.8 of the longest that is stable for it; its
/// accelerations follow. Of all cells, or where not `anew` of those blocks whose contacts have become stiffer than
/// `counted` [block], by how much they have hardened, which is kept. `factor` [slot]: by how much more inertia a cell
/// gets. [settle.h]
void followInertia(World& world, std::span<double> counted, std::span<const double> factor, bool anew);

/// Sets the time step for the cells as they are now: the scene's own, or the automatic one, and evaluates the forces
/// for it if it has changed. Quasi-static scenes have none: there it only evaluates the forces. Throws NumericalError
/// if the scene's own lies above 0.8 of a stability limit, is longer than the shortest cell cycle or than the whole
/// run, or moves a cell by more than maxFlight of its contacts' reach; the text names both numbers.
void chooseTimeStep(World& world);

/// After a step: an automatic time step is chosen anew when contacts have become too stiff for it, and every 64 steps
/// when a longer one would do or cells have become too fast for it (maxFlight).
void followContacts(World& world);

}  // namespace morula

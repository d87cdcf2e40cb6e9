#pragma once
// The stages of a step that concern the whole world; step.cpp calls them in order.
#include <cstdint>
#include <span>

#include "simulation/world.h"

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

/// Moves all cells on by `timeStep` and evaluates every force at the new positions.
void movePhysics(World& world, double timeStep);

/// Evaluates every force where the cells are; nothing moves.
void evaluateForces(World& world);

/// Makes one of the evaluations of a time step, with what comes before and after it. A time step of 0 moves nothing.
void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep);

/// Sets the world's kernels to those of an instruction set. Requires bodies.
void setStages(World& world, Isa isa);

/// Throws NumericalError if a cell's volume is not a positive number below the largest sensible one.
void checkBodies(const World& world);

/// Throws BodyFailure if a cell begins deeper in another one than contacts reach: no force would part the two. Cost:
/// for each pair of cells whose bounding boxes overlap that deep, the vertices of one times the faces of the other.
void checkStart(const World& world);

/// Throws NumericalError if one of these numbers of a cell's state is not finite. The step itself looks at volumes
/// alone: a bad number that they do not show yet reaches them in the next step.
void checkNumbers(const World& world, std::size_t cell, const char* field, std::span<const double> values);
/// Checks all numbers of all cells' bodies in this way.
void checkNumbers(const World& world);

/// Throws NumericalError if a vertex has moved farther in this step than its contacts reach: cells could then pass
/// through each other and never have touched. Must be called with all snapshots, before the list follows.
void checkReach(const World& world);

/// Throws BodyFailure if a cell in flight has more of its volume in another one than sanity allows: cells that meet at
/// high speed crumple, and where vertices slip between vertices, none is seen deep. Looks every 4 steps, and only while
/// contacts are pressed hard.
void checkCrossing(const World& world);

/// Cells that grow or shrink. Returns at once where the scene has no growth.
void growCells(World& world, double timeStep);

/// Tells contacts which cells stick to others alike, by their substances, and what the seed varies. Returns at once
/// where adhesion depends on neither.
void sortByAdhesion(World& world);

/// Runs the cell cycles that are due up to `until` [time], and the deaths, divisions and connections that follow from
/// them. Cycles run in the order in which they are due, cycles due at the same time together; none runs after the one
/// that gives the scene as many cells as it stops at. A cell that does not want its cycle yet is asked again in each
/// step, together with those whose cycles are due at the step's end. `before`: the clock's time before this step.
void runCellCycles(World& world, double before, double until);

/// Runs cell cycles as runCellCycles, and the experiments that are due until then [time], each after the cycles that
/// were due before it.
void runEvents(World& world, double before, double until);

/// [time] The longest cycle that a cell of a scene may have, without what the seed varies.
double longestCycle(const CycleParameters& cycle);

/// [1] A cell's cycle lengths over those of its state: 1 ± variation.cycle, times what experiments say.
double paceOf(const World& world, const CellPath& path, StateId state);

/// Returns when [time] the next cycle of living cell number `cell` is due.
double nextCycleOf(const World& world, std::size_t cell);

/// True once as many cells live as the scene stops at.
bool hasEnoughCells(const World& world);

/// Returns until when [time] cell cycles run in a step from `before` to the clock's time: until the clock's time, or in
/// the step that reaches the planned end, until that end. Later cycles do not run, as they would not without bodies.
double dueUntil(const World& world, double before);

/// Ends connections whose cells are too far apart, that pull too hard or are too old. Returns at once where there are
/// none.
void releaseConnections(World& world);

/// Returns the longest time step [time] that is stable for the cells as they are, with some margin; an automatic one is
/// the power of two below. Requires at least one cell.
double timeStepLimit(const World& world);

/// Returns the automatic time step [time] where steps up to `limit` are stable: the largest power of two up to `limit`
/// and up to the shortest cell cycle that the scene may bring. So no cell has more than one cycle in a step.
double automaticTimeStep(const Scene& scene, double limit);

/// Throws InputError if more cell cycles would come one after the other than any run can make, or if one
/// cycle is so much shorter than another that times cannot tell its beginning from its end.
void refuseEndlessPace(const Scene& scene);

/// Gives each cell the inertia with which a time step of 1 is 0.8 of its longest stable one; its accelerations follow.
/// `anew`: for all cells; otherwise for blocks whose contacts have become stiffer than `counted` [block], which keeps
/// by how much they have hardened. `factor` [slot]: by how much more inertia a cell gets. [settle.h]
void followInertia(World& world, std::span<double> counted, std::span<const double> factor, bool anew);

/// Sets the time step for the present cells, the scene's own or the automatic one, and evaluates the forces for it if
/// it has changed. In quasi-static scenes, which have none, it only evaluates the forces. Throws NumericalError if the
/// scene's own step lies above 0.8 of a stability limit, is longer than the shortest cell cycle or than the whole run,
/// or moves a cell by more than maxFlight of its contacts' reach; the text names both numbers.
void chooseTimeStep(World& world);

/// Chooses an automatic time step anew after a step: when contacts have become too stiff for it, and every 64 steps
/// when a longer one would do or cells have become too fast for it (maxFlight).
void followContacts(World& world);

}  // namespace morula

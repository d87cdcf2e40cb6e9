#pragma once
// The time step: its stability limits, and its choice.
#include <span>

#include "state/world.h"

namespace morula {

/// Throws BodyFailure if a cell in flight has more of its volume in another one than sanity allows: cells that meet at
/// high speed crumple, and where vertices slip between vertices, none is seen deep. Looks every 4 steps, and only while
/// contacts are pressed hard.
void checkCrossing(const World& world);

/// Returns the longest time step [time] that is stable for the cells as they are, with some margin; an automatic one is
/// the power of two below. Requires at least one cell.
double timeStepLimit(const World& world);

/// Returns the automatic time step [time] where steps up to `limit` are stable: the largest power of two up to `limit`
/// and up to the shortest cell cycle that the scene may bring. So no cell has more than one cycle in a step.
double automaticTimeStep(const Scene& scene, double limit);

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

#pragma once
// Births and deaths: the only places where the set of living cells changes.
#include <vector>

#include "simulation/observation.h"

namespace morula {

enum class CellChange : std::uint8_t { none, cycled, divides, dies };

/// Makes all divisions and deaths of one moment. All cuts are tried first; only when all have succeeded does the world
/// change. Throws NumericalError for a division that cannot be done, with its reason. `now`: observes this world as it
/// is, and must not be asked any more afterwards.
void changePopulation(World& world, const Observation& now, const std::vector<CellChange>& changes);

/// Adds a living cell that no division made, at time 0, without a body yet. Cells come in the order of their paths.
void addFounder(World& world, const CellPath& path, StateId state);

/// Starts life with a new set of bodies: makes lists, forces and the time step for them.
void beginWithBodies(World& world);

/// Makes and releases connections between neighbours of which one's cell cycle ran. ConnectionParameters::make says
/// whether they connect by the sum of their wantsToConnect, or unless that sum is below 0.
void connectNeighbours(World& world, const Observation& now, const std::vector<CellChange>& changes);

}  // namespace morula

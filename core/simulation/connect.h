#pragma once
// Connections between neighbours: how they are made, and how they end.
#include "simulation/population.h"

namespace morula {

/// Makes and releases connections between neighbours of which one's cell cycle ran. ConnectionParameters::make says
/// whether they connect by the sum of their wantsToConnect, or unless that sum is below 0.
void connectNeighbours(World& world, const Observation& now, const std::vector<CellChange>& changes);

/// Ends connections whose cells are too far apart, that pull too hard or are too old. Returns at once where there are
/// none.
void releaseConnections(World& world);

}  // namespace morula

#pragma once
// Cells that crawl through the medium on their own [MotilityParameters].
#include "state/world.h"

namespace morula {

/// Adds the active force to all cells: m γ v₀ e, with which drag γ lets a cell alone crawl at v₀ along e. Each cell has
/// a direction of its own for each interval, uniform over all, by (seed, lineage path, interval).
void addMotility(World& world);

}  // namespace morula

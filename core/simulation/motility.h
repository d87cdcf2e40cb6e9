#pragma once
// Cells that crawl through the medium on their own [MotilityParameters].
#include <cstdint>
#include <vector>

#include "base/vec3.h"

namespace morula {

struct World;

/// The directions in which cells crawl, kept so that a steady step draws no numbers.
struct Motility {
  std::uint64_t interval = 0;     // number of the interval of persistence, counted from time 0
  std::vector<Vector> direction;  // [cell]
  bool isCurrent = false;         // direction fits the interval and the cells
};

/// Adds the active force to all cells: m γ v₀ e, with which drag γ lets a cell alone crawl at v₀ along e. Each cell has
/// a direction of its own for each interval, uniform over all, by (seed, lineage path, interval).
void addMotility(World& world);

}  // namespace morula

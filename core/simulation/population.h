#pragma once
// Births and deaths: the only places where the set of living cells changes.
#include <vector>

#include "observation/observation.h"

namespace morula {

enum class CellChange : std::uint8_t { none, cycled, divides, dies };

/// Makes all divisions and deaths of one moment. All cuts are tried first; only when all have succeeded does the world
/// change. Throws NumericalError for a division that cannot be done, with its reason. `now`: observes this world as it
/// is, and must not be asked any more afterwards.
void changePopulation(World& world, const Observation& now, const std::vector<CellChange>& changes);

/// Adds a living cell that no division made, at time 0, without a body yet. Cells come in the order of their paths.
void addFounder(World& world, const CellPath& path, StateId state);

}  // namespace morula

#pragma once
// How long a cell's cycles last, and when its next one is due.
#include <cstddef>

#include "state/world.h"

namespace morula {

/// [1] A cell's cycle lengths over those of its state: 1 ± variation.cycle, times what experiments say.
double paceOf(const World& world, const CellPath& path, StateId state);

/// Returns when [time] the next cycle of living cell number `cell` is due.
double nextCycleOf(const World& world, std::size_t cell);

}  // namespace morula

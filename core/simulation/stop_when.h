#pragma once
// Conditions that end a run, looked at while it goes on.
#include <cstdint>

#include "state/world.h"

namespace morula {

/// Returns the next time [time] after the clock's at which conditions are looked at anyway; infinite without any.
double nextLook(const World& world);

/// Looks at the scene's conditions, and notes in the world the first that holds. Must be called after each step, or
/// after several steps up to nextLook. `before`: the clock's time before [time]. `born`: how many cells the lineage
/// held then.
void lookForStop(World& world, double before, std::size_t born);

}  // namespace morula

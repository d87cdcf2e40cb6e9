#pragma once
// A running world looks at the conditions that may end it.
#include "state/world.h"

namespace morula {

/// Returns the next time [time] after the clock's at which conditions are looked at anyway; infinite without any.
double nextLook(const World& world);

/// The clock and the cells before a step, by which a look knows events.
struct BeforeStep {
  explicit BeforeStep(const World& world)
      : clockTime(world.clock.time), nextCycle(world.clock.nextCycle), cells(world.cells.path.size()) {}
  double clockTime, nextCycle;  // [time]
  std::size_t cells;
};

/// Looks at the scene's conditions, and notes in the world the first that holds. Must be called after each step, or
/// after several steps up to nextLook. Returns at once unless an event took place or a look is due.
void lookForStop(World& world, const BeforeStep& before);

/// Looks at the conditions of a world that no step has been made in.
void lookForStop(World& world);

}  // namespace morula

// The biological step [Nilsson 2008, figure 4.2]: what the cells want is asked first, of the world as it is,
// and done afterwards, so that the order of cells cannot matter.
//
// Cycles that fall within one time step run in the order in which they are due, those due at one time
// together, and each round sees what the one before has made: so biology goes through the same rounds whether
// a time step holds one of them or several, and a lineage is that of the same scene without bodies.
#include <algorithm>
#include <cmath>

#include "simulation/body_unit.h"
#include "simulation/population.h"
#include "simulation/stages.h"

namespace morula {

namespace {

/// Runs the cycle of one cell if it is due at `time`. Its unit sees its body if there is one. Returns what
/// becomes of it.
CellChange runCellCycle(World& world, std::size_t i, double time) {
  Cells& cells = world.cells;
  std::optional<BodyUnit> body;
  if (world.bodies) body.emplace(*world.bodies, world.bodies->slots[i]);
  CellView view{cells.path[i], cells.state[i], time, cells.lastCycle[i], body ? &*body : nullptr};
  if (!world.biology->wantsToRunCellCycle(view)) return CellChange::none;
  cells.lastCycle[i] +=
      world.biology->cycleLength(cells.state[i]);  // when it was due: rounding to steps does not pile up
  view.state = cells.state[i] = world.biology->runCellCycle(view);
  world.lineage.entries[cells.entry[i]].state = cells.state[i];
  if (world.biology->wantsToDie(view)) return CellChange::dies;
  if (world.model.mechanics) cells.growth[i] = world.biology->wantsToGrow(view);
  return world.biology->wantsToDivide(view) ? CellChange::divides : CellChange::cycled;
}

/// All cycles that are due at one time. False if there was none.
bool runOneRound(World& world, double time) {
  std::vector<CellChange> changes(world.cells.path.size());
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = runCellCycle(world, i, time);
  connectByGene(world, changes);
  changePopulation(world, changes);
  return std::any_of(changes.begin(), changes.end(), [](CellChange c) { return c != CellChange::none; });
}

double findNextCycle(const World& world) {
  double next = INFINITY;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    next = std::min(next, world.cells.lastCycle[i] + world.biology->cycleLength(world.cells.state[i]));
  return next;
}

}  // namespace

void runCellCycles(World& world, double until) {
  Clock& clock = world.clock;
  if (!(clock.nextCycle <= until)) return;
  for (bool some = true; some && clock.nextCycle <= until && !hasEnoughCells(world);) {
    some = runOneRound(world, clock.nextCycle);
    clock.nextCycle = findNextCycle(world);
  }
  if (world.bodies && world.model.mechanics->physics.growth) {
    if (world.contacts) setInfluenceRadii(*world.contacts, *world.bodies);
    chooseTimeStep(world);  // cells that shrink get lighter: an automatic step must follow
  }
}

}  // namespace morula

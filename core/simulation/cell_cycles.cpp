// The biological step [Nilsson 2008, figure 4.2]: what the cells want is asked first, of the world as it is,
// and done afterwards, so that the order of cells cannot matter.
#include <algorithm>
#include <cmath>

#include "simulation/body_unit.h"
#include "simulation/population.h"
#include "simulation/stages.h"

namespace morula {

namespace {

/// Runs the cycle of one cell, whose unit sees its body if there is one, and says what becomes of it.
CellChange runCellCycle(World& world, std::size_t i) {
  Cells& cells = world.cells;
  std::optional<BodyUnit> body;
  if (world.bodies) body.emplace(*world.bodies, world.bodies->slots[i]);
  CellView view{cells.path[i], cells.state[i], world.clock.time, cells.lastCycle[i], body ? &*body : nullptr};
  if (!world.biology->wantsToRunCellCycle(view)) return CellChange::none;
  cells.lastCycle[i] +=
      world.biology->cycleLength(cells.state[i]);  // when it was due: rounding to steps does not pile up
  view.state = cells.state[i] = world.biology->runCellCycle(view);
  world.lineage.entries[cells.entry[i]].state = cells.state[i];
  if (world.biology->wantsToDie(view)) return CellChange::dies;
  if (world.model.mechanics) cells.growth[i] = world.biology->wantsToGrow(view);
  return world.biology->wantsToDivide(view) ? CellChange::divides : CellChange::cycled;
}

}  // namespace

void runCellCycles(World& world) {
  std::vector<CellChange> changes(world.cells.path.size());
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = runCellCycle(world, i);
  connectByGene(world, changes);
  changePopulation(world, changes);
  if (world.bodies && world.model.mechanics->physics.growth) {
    if (world.contacts) setInfluenceRadii(*world.contacts, *world.bodies);
    chooseTimeStep(world);  // cells that shrink get lighter: an automatic step must follow
  }
  Clock& clock = world.clock;
  clock.nextCycle = INFINITY;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    clock.nextCycle = std::min(clock.nextCycle,
                               world.cells.lastCycle[i] + world.biology->cycleLength(world.cells.state[i]));
}

}  // namespace morula

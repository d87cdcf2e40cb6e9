
#include "state/pace.h"

#include "base/random.h"
#include "state/experiment_record.h"

namespace morula {
namespace {

/// [1] By how much experiments lengthen the cycles of a cell with this path and state.
double experimentalPace(const World& world, const CellPath& path, StateId state) {
  double pace = 1;
  if (!world.experiments) return pace;
  for (std::uint64_t number = 1; number <= world.model.experiments.size(); ++number) {
    const Experiment& e = world.model.experiments[number - 1];
    if (e.deed != Deed::cycles) continue;
    const bool holds =
        e.afterBirth ? wasDoneTo(world, number, path)
                     : wasDone(world, number) && selects(e, world, path, state) && isChosen(e, world, number, path);
    if (holds) pace *= e.value;
  }
  return pace;
}

}  // namespace

double paceOf(const World& world, const CellPath& path, StateId state) {
  const double sd = world.model.variation.cycle;
  const double own = sd == 0 ? 1 : 1 + sd * randomDeviate({world.model.seed, path, 0, Purpose::cycleVariation});
  return world.experiments ? own * experimentalPace(world, path, state) : own;
}

double nextCycleOf(const World& world, std::size_t cell) {
  const Cells& cells = world.cells;
  const StateId state = cells.state[cell];
  return cells.lastCycle[cell] + paceOf(world, cells.path[cell], state) * world.biology->cycleLength(state);
}

}  // namespace morula

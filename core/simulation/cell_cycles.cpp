// The biological step [Nilsson 2008, figure 4.2]: observe, decide, apply. All cells that are due run their cycle on the
// same instant, into new states. When all have changed, their wishes are asked of that instant, and carried out
// afterwards. So the order of cells cannot matter, whatever they know of one another.
//
// Cycles that fall within one time step run in the order in which they are due, cycles due at one time together, and
// each round sees the result of the round before. So biology goes through the same rounds whether a time step holds one
// of them or several, and the lineage is that of the same scene without bodies.
#include "simulation/cell_cycles.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/random.h"
#include "contacts/contacts.h"
#include "observation/observation.h"
#include "simulation/adhesion_kinds.h"
#include "simulation/connect.h"
#include "simulation/cycle_lengths.h"
#include "simulation/experiments.h"
#include "simulation/population.h"
#include "simulation/run_end.h"
#include "simulation/time_step.h"
#include "state/pace.h"

namespace morula {
namespace {

/// Runs the cycles that are due. Returns which cells had one.
std::vector<CellChange> runDueCycles(World& world, double time) {
  Cells& cells = world.cells;
  std::vector<CellChange> changes(cells.path.size(), CellChange::none);
  std::vector<StateId> next = cells.state;
  const Observation now(world, time);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const ObservedCell cell(now, static_cast<int>(i));
    if (!world.biology->wantsToRunCellCycle(cell)) continue;
    next[i] = world.biology->runCellCycle(cell);
    changes[i] = CellChange::cycled;
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i] == CellChange::none) continue;
    // Keeps when the cycle was due: rounding to steps does not pile up. A cell that has waited begins anew now.
    cells.lastCycle[i] = std::max(time, nextCycleOf(world, i));
    world.lineage.entries[cells.entry[i]].state = next[i];
  }
  cells.state = std::move(next);
  return changes;
}

/// Asks the cells whose cycle has run for their wishes.
void decide(World& world, const Observation& now, std::vector<CellChange>& changes) {
  const BiologicalUnit& biology = *world.biology;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    if (changes[i] == CellChange::none) continue;
    const ObservedCell cell(now, static_cast<int>(i));
    if (biology.wantsToDie(cell)) {
      changes[i] = CellChange::dies;
      continue;
    }
    if (world.model.mechanics) world.cells.growth[i] = biology.wantsToGrow(cell);
    if (biology.wantsToDivide(cell)) changes[i] = CellChange::divides;
  }
}

/// Reads the genes of the cells that were born into the lineage from entry `first` on.
void readAtBirth(World& world, double time, std::size_t first) {
  Cells& cells = world.cells;
  std::vector<StateId> next = cells.state;
  const Observation now(world, time);
  for (std::size_t i = 0; i < next.size(); ++i)
    if (cells.entry[i] >= first) next[i] = world.biology->runCellCycle(ObservedCell(now, static_cast<int>(i)));
  for (std::size_t i = 0; i < next.size(); ++i)
    if (cells.entry[i] >= first) world.lineage.entries[cells.entry[i]].state = next[i];
  cells.state = std::move(next);
}

/// Runs all cycles that are due at one time. Returns false if no cell wanted one.
bool runOneRound(World& world, double time) {
  std::vector<CellChange> changes = runDueCycles(world, time);
  if (std::ranges::all_of(changes, [](CellChange c) { return c == CellChange::none; })) return false;
  const Observation now(world, time);
  decide(world, now, changes);
  connectNeighbours(world, now, changes);
  const std::size_t before = world.lineage.entries.size();
  changePopulation(world, now, changes);
  if (world.model.cycle.first == FirstCycle::atBirth && world.lineage.entries.size() > before)
    readAtBirth(world, time, before);
  return true;
}

/// Returns the time of the round after that of `time`: when the next cycle is due. For cells that did not want a due
/// cycle it is the clock's time. It is `time` itself if only such cells are left and have been asked then.
double findNextRound(const World& world, double time) {
  double next = INFINITY;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const double due = nextCycleOf(world, i);
    next = std::min(next, due > time ? due : std::max(time, world.clock.time));
  }
  return next;
}

/// Throws NumericalError if a run that only stop.cells and stop.when can end has taken maxCyclesForCells of its longest
/// cycles without coming to that: its cells may have stopped dividing, and then the run would never end.
void requireCellsInTime(const World& world) {
  const Scene& scene = world.model;
  if ((!scene.stop.cells && scene.stop.when.empty()) || plannedEnd(scene) || hasEnoughCells(world)) return;
  if (!(world.clock.time > double(maxCyclesForCells) * longestCycle(scene.cycle))) return;
  if (!scene.stop.cells)
    throw NumericalError(world.clock.step,
                         "stop.when: no condition has held in " + std::to_string(maxCyclesForCells) + " cycles",
                         "correct the condition, or give a stop.time or stop.cycles besides");
  throw NumericalError(world.clock.step,
                       "stop.cells: " + std::to_string(*scene.stop.cells) + " cells do not live within " +
                           std::to_string(maxCyclesForCells) + " cycles: " + std::to_string(world.cells.path.size()) +
                           " live",
                       "give fewer stop.cells, or also a stop.time or stop.cycles");
}

void findAdhesion(World& world) {
  // Measures before the next step see the substances that cells hold now, as a checkpoint of now will have them.
  if (world.contacts && world.contacts->parameters.adhesion && !world.contacts->adhesion.isCurrent)
    findPairStrengths(*world.contacts, *world.bodies, world.execution.threads);
}

}  // namespace

void runCellCycles(World& world, double before, double until) {
  Clock& clock = world.clock;
  requireCellsInTime(world);
  if (!(clock.nextCycle <= until)) return;
  // Cells that wait for a size have a next cycle in the past; so has a state that another stop has cut short, whose
  // cycles still count from when they were due.
  const bool someWait = world.model.cycle.divisionSize && clock.nextCycle <= before;
  double time = someWait ? findNextRound(world, before) : clock.nextCycle;
  bool some = false, isOver = false;
  while (!isOver && time <= until && !hasEnoughCells(world)) {
    some = runOneRound(world, time) || some;
    clock.nextCycle = findNextRound(world, time);
    isOver = !(clock.nextCycle > time);
    time = clock.nextCycle;
  }
  sortByAdhesion(world);
  if (some && world.bodies && world.model.mechanics->physics.growth) {
    if (world.contacts) setInfluenceRadii(*world.contacts, *world.bodies);
    chooseTimeStep(world);  // cells that shrink get lighter: an automatic step must follow
  }
  findAdhesion(world);
}

void runEvents(World& world, double before, double until) {
  for (;;) {
    const double next = nextExperiment(world), time = std::min(std::max(before, next), until);
    runCellCycles(world, before, time);
    // Cycles may have brought the number of cells that an experiment waits for.
    if (!(nextExperiment(world) <= time)) {
      if (!(next <= until)) return;
      continue;
    }
    doExperiments(world, time);
    world.clock.nextCycle = findNextRound(world, time);
    sortByAdhesion(world);
    findAdhesion(world);
  }
}

}  // namespace morula

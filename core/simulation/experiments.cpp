
#include "simulation/experiments.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "base/random.h"
#include "connections/connections.h"
#include "contacts/contacts.h"
#include "observation/observation.h"
#include "simulation/make_world.h"
#include "simulation/population.h"
#include "state/experiment_record.h"

namespace morula {
namespace {

const std::vector<Experiment>& listOf(const World& world) { return world.model.experiments; }

double bornAt(const World& world, std::size_t cell) { return world.lineage.entries[world.cells.entry[cell]].born; }

/// [time] When an experiment is due for the living cell; infinite if it is not for this cell, or has been done to it.
double dueFor(const World& world, std::uint64_t number, std::size_t cell) {
  const Experiment& e = listOf(world)[number - 1];
  const CellPath& path = world.cells.path[cell];
  if (!selects(e, world, path, world.cells.state[cell]) || !isChosen(e, world, number, path)) return INFINITY;
  return wasDoneTo(world, number, path) ? INFINITY : bornAt(world, cell) + *e.afterBirth;
}

/// [time] When an experiment is due; infinite if it has been done, or waits for what has not come.
double dueTime(const World& world, std::uint64_t number) {
  const Experiment& e = listOf(world)[number - 1];
  if (e.afterBirth) {
    double first = INFINITY;
    for (std::size_t i = 0; i < world.cells.path.size(); ++i) first = std::min(first, dueFor(world, number, i));
    return first;
  }
  if (wasDone(world, number)) return INFINITY;
  if (e.at) return *e.at;
  return world.cells.path.size() >= *e.atCells ? world.clock.time : INFINITY;
}

/// The numbers of the living cells for which the experiment is due at this time.
std::vector<std::size_t> cellsOf(const World& world, std::uint64_t number, double time) {
  const Experiment& e = listOf(world)[number - 1];
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    const CellPath& path = world.cells.path[i];
    const bool isDue = e.afterBirth ? dueFor(world, number, i) <= time
                                    : selects(e, world, path, world.cells.state[i]) && isChosen(e, world, number, path);
    if (isDue) cells.push_back(i);
  }
  return cells;
}

void note(World& world, std::uint64_t number, DoneTo to, const CellPath& path = {}, const CellPath& other = {}) {
  world.experiments->push_back({number, world.clock.time, world.clock.step, to, path, other});
}

/// Throws NumericalError: none of the cells that an experiment is for lives at its time.
[[noreturn]] void refuseNoCell(const World& world, std::uint64_t number) {
  const Experiment& e = listOf(world)[number - 1];
  std::string who, lives;
  for (const CellSelection& selection : e.of) {
    const bool one = selection.kind == CellSelection::Kind::cell;
    who += (who.empty() ? "" : ", ") + (one ? cellName(selection.path.text()) : AskedCells{selection}.text());
    if (one)
      for (const LineageEntry& entry : world.lineage.entries)
        if (entry.path == selection.path && entry.fate != Fate::alive)
          lives = "; " + cellName(entry.path.text()) + " lived from " + numberText(entry.born) + " to " +
                  numberText(entry.ended);
  }
  throw NumericalError(world.clock.step,
                       std::string("experiments[") + std::to_string(number - 1) + "]." + nameOf(e.deed) + " at time " +
                           numberText(world.clock.time) + ": " + (who.empty() ? "no cell" : who) +
                           " does not live then" + lives,
                       "give another time, or after-birth or at-cells in place of at");
}

void kill(World& world, const std::vector<std::size_t>& cells, double time) {
  std::vector<CellChange> changes(world.cells.path.size(), CellChange::none);
  for (const std::size_t cell : cells) changes[cell] = CellChange::dies;
  changePopulation(world, Observation(world, time), changes);
}

void setParameter(World& world, const Experiment& e) {
  MORULA_CHECK(world.bodies, "a parameter of an experiment exists in its scene");
  PhysicsParameters& physics = world.bodies->parameters;
  const ChangeableParameter* const row = changeableParameter(e.name);
  double* const value = row ? row->of(physics, world.contacts ? &world.contacts->parameters : nullptr) : nullptr;
  MORULA_CHECK(value, "a parameter of an experiment exists in its scene");
  *value = e.value;
  world.bodies->kernelParameters = kernelParametersOf(physics);
}

/// Brings genes and parameters to what the experiment says. Returns true if it is about these.
bool applyToAll(World& world, const Experiment& e) {
  if (e.deed == Deed::geneOff || e.deed == Deed::geneOn) world.biology->setGene(e.name, e.deed == Deed::geneOn);
  else if (e.deed == Deed::set) setParameter(world, e);
  else return false;
  return true;
}

void connectCells(World& world, std::uint64_t number) {
  const Experiment& e = listOf(world)[number - 1];
  const Cells& cells = world.cells;
  const auto living = [&](const CellSelection& selection) {
    std::vector<CellPath> found;
    for (std::size_t i = 0; i < cells.path.size(); ++i)
      if (selection.has(cells.path[i], world.biology->describe(cells.state[i]))) found.push_back(cells.path[i]);
    return found;
  };
  bool some = false;
  for (const CellPath& a : living(e.of[0]))
    for (const CellPath& b : living(e.of[1])) {
      if (a == b) continue;
      if (e.deed == Deed::connect) connect(*world.connections, a, b, world.clock.time);
      else if (areConnected(*world.connections, a, b))
        release(*world.connections, a, b, world.clock.time, ReleaseCause::experiment);
      else continue;
      note(world, number, DoneTo::pair, a, b);
      some = true;
    }
  if (!some && e.deed == Deed::connect) refuseNoCell(world, number);
  if (!some) note(world, number, DoneTo::nobody);
}

void doOne(World& world, std::uint64_t number, double time) {
  const Experiment& e = listOf(world)[number - 1];
  if (applyToAll(world, e)) {
    note(world, number, DoneTo::all);
    if (e.deed == Deed::set) beginWithBodies(world);
    return;
  }
  if (e.deed == Deed::connect || e.deed == Deed::release) return connectCells(world, number);
  const std::vector<std::size_t> cells = cellsOf(world, number, time);
  for (const std::size_t cell : cells) note(world, number, DoneTo::cell, world.cells.path[cell]);
  if (cells.empty()) {
    if (e.share >= 1 && e.deed != Deed::cycles) refuseNoCell(world, number);
    note(world, number, DoneTo::nobody);
  }
  if (e.deed == Deed::delay)
    for (const std::size_t cell : cells) world.cells.lastCycle[cell] += e.value;
  if (e.deed == Deed::kill && !cells.empty()) kill(world, cells, time);
}

}  // namespace

double nextExperiment(const World& world) {
  double next = INFINITY;
  if (world.experiments)
    for (std::uint64_t number = 1; number <= listOf(world).size(); ++number)
      next = std::min(next, dueTime(world, number));
  return next;
}

void doExperiments(World& world, double time) {
  for (std::uint64_t number = 1; number <= listOf(world).size(); ++number)
    if (dueTime(world, number) <= time) doOne(world, number, time);
}

void restoreExperiments(World& world) {
  if (!world.experiments) return;
  for (const ExperimentRecord& record : *world.experiments)
    if (record.number >= 1 && record.number <= listOf(world).size())
      applyToAll(world, listOf(world)[record.number - 1]);
}

}  // namespace morula

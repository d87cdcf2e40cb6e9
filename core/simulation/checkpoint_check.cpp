// What must hold of a state before it is taken over: then nothing that follows can read past an end. The hash
// of the file finds damage; this finds what was written by something else than this program.
#include <algorithm>
#include <cmath>
#include <set>

#include "simulation/checkpoint_state.h"
#include "simulation/settle.h"

namespace morula {
namespace {

/// Written so that infinities fail.
bool isPositive(double a) { return a > 0 && a < INFINITY; }

void checkClock(const Clock& c, bool hasTimeStep) {
  demand(std::isfinite(c.time) && std::isfinite(c.epochTime) && c.epochStep <= c.step, "the clock");
  if (hasTimeStep) demand(isPositive(c.timeStep), "the time step");
}

/// The living cells and their entries belong to each other.
void checkCells(const Cells& cells, const std::vector<LineageEntry>& entries) {
  const auto alive = std::ranges::count(entries, Fate::alive, &LineageEntry::fate);
  const auto& path = cells.path;
  demand(static_cast<std::size_t>(alive) == path.size(), "the living cells are not those of the lineage");
  for (std::size_t i = 0; i < path.size(); ++i) {
    demand(i == 0 || path[i - 1] < path[i], "the order of cells");
    const std::size_t entry = cells.entry[i];
    demand(entry < entries.size() && entries[entry].path == path[i] && entries[entry].fate == Fate::alive,
           cellName(path[i].text()) + " is not in the lineage");
  }
  for (double time : cells.lastCycle) demand(std::isfinite(time), "the time of a cell cycle");
}

void checkConnections(const std::vector<ConnectionRecord>& history, const std::vector<CellPath>& living) {
  std::set<std::pair<CellPath, CellPath>> active;
  const auto lives = [&](const CellPath& path) { return std::ranges::binary_search(living, path); };
  for (const auto& [a, b, made, released, cause] : history) {
    const bool holds = released < 0;
    demand(a < b && cause && (!holds || (lives(a) && lives(b) && active.insert({a, b}).second)),
           "a connection of '" + a.text() + "' and '" + b.text() + "'");
  }
}

void checkPolarities(const std::vector<PolarityRecord>& polarities) {
  for (std::size_t i = 0; i < polarities.size(); ++i)
    demand(
        (i == 0 || polarities[i - 1].path < polarities[i].path) && std::abs(norm(polarities[i].direction) - 1) < 1e-6,
        "the polarity that '" + polarities[i].path.text() + "' left to its daughters");
}

}  // namespace

void checkSavedState(const SavedState& s, const World& world) {
  const World& read = s.world;
  checkClock(read.clock, world.bodies && !settles(world));
  checkCells(read.cells, read.lineage.entries);
  if (world.bodies)
    for (int slot : read.bodies->slots)
      demand(isPositive(read.bodies->vertexMass[slot]) && isPositive(read.bodies->restScale[slot]),
             "a cell's mass or size");
  for (const Columns* radii : {&s.contacts.radius, &s.contacts.snapshotRadius})
    for (double a : *radii) demand(isPositive(a), "a cell's influence radius");
  if (world.polarities) checkPolarities(*read.polarities);
  if (world.connections) checkConnections(read.connections->history, read.cells.path);
  if (world.birthSizes) {
    demand(read.birthSizes->size() == read.cells.path.size(), "a cell's size at birth");
    for (const BirthSize& birth : *read.birthSizes) demand(isPositive(birth.size), "a cell's size at birth");
  }
}

}  // namespace morula

// What must hold of a state before it is taken over: then nothing that follows can read past an end. The hash
// of the file finds damage; this finds what was written by something else than this program.
#include <algorithm>
#include <cmath>
#include <set>

#include "base/cell_path.h"
#include "base/error.h"
#include "simulation/saved_state.h"
#include "simulation/world.h"

namespace morula {

namespace {

void demand(bool holds, const std::string& what) {
  if (!holds) throw InputError("checkpoint: its parts contradict each other: " + what);
}

template <class... Columns>
void demandLength(std::size_t length, const char* group, const Columns&... columns) {
  demand(((columns.size() == length) && ...), std::string(group) + " have columns of different lengths");
}

/// Written so that infinities fail.
bool isPositive(double a) { return a > 0 && a < INFINITY; }

void checkClock(const SavedState& s, const World& world) {
  demand(std::isfinite(s.time) && std::isfinite(s.epochTime) && s.epochStep <= s.step, "the clock");
  if (world.bodies) demand(isPositive(s.timeStep), "the time step");
  demandLength(s.timeSteps.time.size(), "time steps", s.timeSteps.step, s.timeSteps.timeStep);
}

void checkStates(const SavedState& s, const World& world) {
  for (const std::string& text : s.states) world.biology->stateOf(text);
  for (const Numbers* places : {&s.cells.state, &s.lineage.state})
    for (std::uint64_t place : *places) demand(place < s.states.size(), "a cell has no state");
}

/// The living cells and their entries belong to each other.
void checkCells(const SavedState& s) {
  const auto& [path, state, entry, lastCycle, growth] = s.cells;
  const auto& l = s.lineage;
  demandLength(path.size(), "cells", state, entry, lastCycle, growth);
  demandLength(l.path.size(), "lineage entries", l.born, l.ended, l.bornStep, l.endedStep, l.fate, l.state);
  for (const std::string& text : l.path) CellPath::parse(text);
  for (std::uint64_t fate : l.fate) demand(fate <= static_cast<std::uint64_t>(Fate::died), "an unknown fate");
  const auto alive = std::count(l.fate.begin(), l.fate.end(), static_cast<std::uint64_t>(Fate::alive));
  demand(static_cast<std::size_t>(alive) == path.size(), "the living cells are not those of the lineage");
  for (std::size_t i = 0; i < path.size(); ++i) {
    demand(i == 0 || CellPath::parse(path[i - 1]) < CellPath::parse(path[i]), "the order of cells");
    demand(entry[i] < l.path.size() && l.path[entry[i]] == path[i] && l.fate[entry[i]] == 0,
           cellName(path[i]) + " is not in the lineage");
  }
  for (double time : lastCycle) demand(std::isfinite(time), "the time of a cell cycle");
}

/// How many numbers positions, velocities and the like have. Also that the meshes are the scene's.
std::size_t countCoordinates(const SavedState& s, const Bodies& bodies) {
  std::size_t vertices = 0;
  for (std::uint64_t coarseness : s.bodies.coarseness) {
    demand(coarseness <= bodies.coarser.size(), "a cell has a mesh that the scene has not");
    vertices += bodies.meshAt(static_cast<int>(coarseness)).vertexCount();
  }
  return 3 * vertices;
}

void checkBodies(const SavedState& s, const World& world) {
  const auto& b = s.bodies;
  demandLength(s.cells.path.size(), "bodies", b.coarseness, b.vertexMass, b.restScale, b.pressureConstant,
               b.volume, b.pressure);
  const auto& d = s.divisions;
  demandLength(d.path.size(), "divisions", d.time, d.step, d.share, d.extentRatio);
  demandLength(3 * d.path.size(), "divisions", d.axis);
  for (const std::string& path : d.path) CellPath::parse(path);
  const std::size_t coordinates = countCoordinates(s, *world.bodies);
  demandLength(coordinates, "bodies", b.position, b.velocity, b.acceleration);
  for (const auto* values : {&b.vertexMass, &b.restScale})
    for (double a : *values) demand(isPositive(a), "a cell's mass or size");
  if (!world.contacts) return;
  demandLength(s.cells.path.size(), "contacts", s.contacts.radius, s.contacts.shownRadius);
  demandLength(coordinates, "contacts", s.contacts.reference);
  demandLength(10, "contacts", s.contacts.counters);
  for (const auto* radii : {&s.contacts.radius, &s.contacts.shownRadius})
    for (double a : *radii) demand(isPositive(a), "a cell's influence radius");
}

void checkConnections(const SavedState& s) {
  const auto& c = s.connections;
  demandLength(c.a.size(), "connections", c.b, c.made, c.released, c.cause);
  std::set<std::pair<std::string, std::string>> active;
  const auto lives = [&](const std::string& path) {
    return std::binary_search(s.cells.path.begin(), s.cells.path.end(), path);
  };
  for (std::size_t i = 0; i < c.a.size(); ++i) {
    const std::string pair = "a connection of '" + c.a[i] + "' and '" + c.b[i] + "'";
    demand(CellPath::parse(c.a[i]) < CellPath::parse(c.b[i]), pair);
    demand(std::find(releaseCauses.begin(), releaseCauses.end(), c.cause[i]) != releaseCauses.end(), pair);
    if (c.released[i] < 0)
      demand(lives(c.a[i]) && lives(c.b[i]) && active.insert({c.a[i], c.b[i]}).second, pair);
  }
}

}  // namespace

void checkSavedState(const SavedState& s, const World& world) {
  checkClock(s, world);
  checkStates(s, world);
  checkCells(s);
  if (world.bodies) checkBodies(s, world);
  if (world.connections) checkConnections(s);
}

}  // namespace morula

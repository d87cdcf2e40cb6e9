#pragma once
// Worlds for tests: from a scene, or from cells put together by hand.
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "contacts/contacts.h"
#include "observation/measures.h"
#include "scenes.h"
#include "simulation/make_world.h"
#include "simulation/population.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"
#include "unit/physics/lab.h"

namespace morula {

inline void runToEnd(World& world) {
  while (!finished(world)) step(world);
}

inline void runTo(World& world, double time) {
  while (world.clock.time < time) step(world);
}

inline World ranToEnd(const Scene& scene, const Execution& execution = {}) {
  World world = makeWorld(scene, execution);
  runToEnd(world);
  return world;
}

inline World ranTo(const Scene& scene, double time, const Execution& execution = {}) {
  World world = makeWorld(scene, execution);
  runTo(world, time);
  return world;
}

/// Returns the NumericalError with which `what` fails, if it does.
inline std::optional<NumericalError> failureOf(const std::function<void()>& what) {
  try {
    what();
    return {};
  } catch (const NumericalError& error) { return error; }
}

/// Returns the residual that rest.h defines, vertex by vertex.
inline double residualByVertices(const World& world) {
  const Bodies& b = *world.bodies;
  double left = 0, pressure = 0;
  int vertices = 0;
  for (int slot : b.slots) {
    const double radius = std::cbrt(3 * b.volume[slot] / (4 * std::numbers::pi));
    const double share = 4 * std::numbers::pi * radius * radius / b.vertexCount(slot);
    for (int v = 0; v < b.vertexCount(slot); ++v) {
      const Vector traction = b.vertexMass[slot] / share * b.read(b.acceleration, slot, v);
      left += dot(traction, traction);
      ++vertices;
    }
    pressure += std::max(std::abs(b.pressure[slot]), 0.1 * b.parameters.membrane.stiffness / radius) / b.count;
  }
  return std::sqrt(left / vertices) / pressure;
}

/// Returns the largest distance of a vertex between two worlds with the same cells. [length]
inline double farthestApart(const World& one, const World& other) {
  Worst farthest;
  for (int slot : one.bodies->slots)
    for (int v = 0; v < one.bodies->vertexCount(slot); ++v)
      farthest.see(norm(one.bodies->vertex(slot, v) - other.bodies->vertex(slot, v)));
  return farthest;
}

/// Returns a world in which the given bodies live under paths of equal length and never run a cell cycle.
inline World worldOf(const Scene& scene, const std::vector<Body>& bodies, const Execution& execution = {},
                     std::unique_ptr<BiologicalUnit> biology = nullptr) {
  World world = biology ? makeWorld(scene, std::move(biology), execution) : makeWorld(scene, execution);
  const StateId state = world.cells.state[0];
  world.cells = {};
  world.lineage.entries.clear();
  int letters = 0;
  while ((1u << letters) < bodies.size()) ++letters;
  for (std::uint32_t i = 0; i < bodies.size(); ++i) {
    CellPath path;
    for (int k = letters - 1; k >= 0; --k) path = path.daughter(i >> k & 1);
    addFounder(world, path, state);
  }
  world.clock.nextCycle = INFINITY;
  setBodies(*world.bodies, bodies);
  beginWithBodies(world);
  return world;
}

/// Returns the world of balls with the scene's mesh, at rest about these places.
inline World ballsAt(const Scene& scene, const std::vector<Vector>& places) {
  std::vector<Body> cells;
  for (const Vector& place : places) cells.push_back(ballAt(scene.mechanics->mesh, place, 200));
  return worldOf(scene, cells);
}

/// Returns a scene of spheres of radius 1 and mass 1 that never divide, without shell, drag, viscosity and damping.
inline Scene looseBalls(std::vector<StartCell> cells) {
  Scene s = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1000);
  s.mechanics->physics.cell = {1, 1, CellModel::sphere};
  s.mechanics->physics.timeStep = 0x1p-10;
  s.mechanics->contact = ContactParameters{ContactLaw::pair, 30, 0, 0, 0.01, 1};
  s.cells = std::move(cells);
  return s;
}

/// Biology of cells with one state that want nothing; tests override what they need.
struct IdleUnit : BiologicalUnit {
  StateId startState() const override { return 0; }
  double cycleLength(StateId) const override { return 1; }
  StateId runCellCycle(const CellContext& cell) override { return cell.state; }
  bool wantsToDivide(const CellContext&) const override { return false; }
  bool wantsToDie(const CellContext&) const override { return false; }
  double wantsToGrow(const CellContext&) const override { return 0; }
  double wantsToConnect(const CellContext&) const override { return 0; }
  StateId daughterState(StateId mother, bool) override { return mother; }
  std::string describe(StateId state) const override { return std::to_string(state); }
};

/// Returns balls on a cubic lattice of 2 × 2 × n with centres `distance` apart, each aimed slightly past the middle.
inline std::vector<Body> flyingCells(const Mesh& ball, int count, double distance, double speed) {
  std::vector<Body> cells;
  for (int i = 0; i < count; ++i) {
    const Point place = distance * Vector{(i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2) - 0.5};
    Body b = shakenBody(ball, 0, 0.01, static_cast<std::uint32_t>(i));
    b.mass = 1 + 0.1 * i;
    b.pressureConstant = 200;
    for (Point& x : b.position) x += place;
    const Vector towards = -1.0 * place + 0.3 * noiseVector(static_cast<std::uint32_t>(i), 9);
    for (Vector& u : b.velocity) u += (speed / norm(towards)) * towards;
    cells.push_back(b);
  }
  return cells;
}

/// Returns flyingCells, where every second cell has the scene's first coarser mesh.
inline std::vector<Body> mixedCells(const Scene& scene, int count, double distance, double speed) {
  const MechanicsScene& m = *scene.mechanics;
  std::vector<Body> cells = flyingCells(m.mesh, count, distance, speed);
  const std::vector<Body> coarse = flyingCells(m.coarser[0], count, distance, speed);
  for (int i = 1; i < count; i += 2) {
    cells[i] = coarse[i];
    cells[i].meshLevel = 1;
  }
  return cells;
}

inline std::vector<std::string> pathsOf(const World& world) {
  std::vector<std::string> texts;
  for (const CellPath& p : world.cells.path) texts.push_back(p.text());
  return texts;
}

inline int slotOf(const World& world, const char* path) {
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    if (world.cells.path[i].text() == path) return static_cast<int>(i);
  return -1;
}

inline Point centreOf(const World& world, const char* path) {
  return measureCentroid(cellVertices(world, CellPath::parse(path)));
}

/// Returns the time at which each cell was born, by path. [time]
inline std::map<std::string, double> birthsOf(const World& world) {
  std::map<std::string, double> births;
  for (const LineageEntry& e : world.lineage.entries) births[e.path.text()] = e.born;
  return births;
}

/// Returns the connected pairs as "AA-B".
inline std::set<std::string> pairsOf(const World& world) {
  std::set<std::string> pairs;
  for (std::size_t i : world.connections->active) {
    const ConnectionRecord& r = world.connections->history[i];
    pairs.insert(r.a.text() + "-" + r.b.text());
  }
  return pairs;
}

/// Returns the substances of each living cell.
inline std::vector<std::string> statesOf(const World& world) {
  std::vector<std::string> states;
  for (StateId state : world.cells.state) states.push_back(world.biology->describe(state));
  return states;
}

}  // namespace morula


#include "simulation/start_cells.h"

#include <algorithm>
#include <span>

#include "base/angle.h"
#include "simulation/population.h"
#include "state/pace.h"

namespace morula {
namespace {

StateId stateOf(const StartCell& cell, BiologicalUnit& biology) {
  if (!cell.substances) return biology.startState();
  std::string description;
  for (const std::string& name : *cell.substances) description += (description.empty() ? "" : " ") + name;
  return biology.stateOf(description);
}

/// Founds a mother's cells before her sister's, A before B: in the order of births.
void found(World& world, const CellPath& path, std::span<const StartCell> cells) {
  if (cells.size() == 1) {
    addFounder(world, path, stateOf(cells[0], *world.biology));
    return;
  }
  world.lineage.entries.push_back({path, 0, 0, 0, 0, Fate::divided, world.biology->startState()});
  const std::size_t half = cells.size() - cells.size() / 2;
  found(world, path.daughter(false), cells.first(half));
  found(world, path.daughter(true), cells.subspan(half));
}

/// Adds the paths of `count` cells that descend from this one.
void addPaths(std::vector<CellPath>& paths, const CellPath& path, std::size_t count) {
  if (count == 1) return paths.push_back(path);
  const std::size_t half = count - count / 2;
  addPaths(paths, path.daughter(false), half);
  addPaths(paths, path.daughter(true), count - half);
}

}  // namespace

std::vector<CellPath> founderPaths(std::size_t count) {
  std::vector<CellPath> paths;
  if (count > 0) addPaths(paths, CellPath{}, count);
  return paths;
}

void createFounders(World& world) {
  if (world.model.cells.empty()) addFounder(world, CellPath{}, world.biology->startState());
  else found(world, CellPath{}, world.model.cells);
  world.clock.nextCycle = nextCycleOf(world, 0);
  for (std::size_t i = 1; i < world.cells.path.size(); ++i)
    world.clock.nextCycle = std::min(world.clock.nextCycle, nextCycleOf(world, i));
}

Point placeVertex(const StartCell& cell, const Point& x) {
  const Vector& s = cell.stretch;
  const Point turned = turnedBy(cell.turn, x);
  return cell.at + cell.scale * Vector{s.x * turned.x, s.y * turned.y, s.z * turned.z};
}

std::vector<Body> makeStartBodies(const Bodies& bodies, const std::vector<StartCell>& cells) {
  if (cells.empty()) return {makeEgg(bodies)};
  std::vector<Body> all;
  for (const StartCell& cell : cells) {
    const double share = cell.scale * cell.scale * cell.scale;
    Body body = makeEgg(bodies);
    for (Point& x : body.position) x = placeVertex(cell, x);
    for (Vector& u : body.velocity) u = cell.velocity;
    body.mass = cell.mass.value_or(body.mass * share);
    body.restScale = cell.scale;
    body.pressureConstant *= share;
    all.push_back(std::move(body));
  }
  return all;
}

}  // namespace morula

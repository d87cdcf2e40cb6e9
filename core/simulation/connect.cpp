// Connections by gene, and their end by distance [Nilsson 2008, §4.1.1, §4.4.3].
#include <algorithm>

#include "base/maths.h"
#include "simulation/body_unit.h"
#include "simulation/population.h"
#include "simulation/stages.h"

namespace morula {

namespace {

double wantsToConnect(const World& world, int cell) {
  const BodyUnit body(*world.bodies, world.bodies->slots[cell]);
  return world.biology->wantsToConnect({world.cells.path[cell], world.cells.state[cell], world.clock.time,
                                        world.cells.lastCycle[cell], &body});
}

int cellOf(const World& world, const CellPath& path) {
  const auto& paths = world.cells.path;
  return static_cast<int>(std::lower_bound(paths.begin(), paths.end(), path) - paths.begin());
}

/// Of the sphere that holds the cell's volume.
double radius(const Bodies& b, int slot) { return cubeRoot(3 * b.volume[slot] / 12.566370614359172); }

}  // namespace

void connectByGene(World& world, const std::vector<CellChange>& changes) {
  if (!world.connections || world.connections->parameters.make == MakeConnections::atDivision) return;
  Connections& connections = *world.connections;
  const double time = world.clock.time;
  const auto cycled = [&](int cell) {
    return changes[cell] != CellChange::none && changes[cell] != CellChange::dies;
  };

  const auto active = connections.active;  // release changes the list
  for (std::size_t i : active) {
    const auto& [a, b] = std::pair{connections.history[i].a, connections.history[i].b};
    const int cellA = cellOf(world, a), cellB = cellOf(world, b);
    if ((cycled(cellA) || cycled(cellB)) && wantsToConnect(world, cellA) + wantsToConnect(world, cellB) < 0)
      release(connections, a, b, time, "gene");
  }
  if (!world.contacts) return;  // without contact nobody is a neighbour
  for (const ContactArea& touch : measureContactAreas(*world.contacts, *world.bodies))
    if ((cycled(touch.a) || cycled(touch.b)) &&
        wantsToConnect(world, touch.a) + wantsToConnect(world, touch.b) > 0)
      connect(connections, world.cells.path[touch.a], world.cells.path[touch.b], time);
}

void releaseConnections(World& world) {
  if (!world.connections || !world.connections->parameters.releaseDistance) return;
  Connections& c = *world.connections;
  const Bodies& bodies = *world.bodies;
  for (std::size_t k = c.active.size();
       k-- > 0;) {  // from behind, for release takes the pair out of the list
    const CellPath a = c.history[c.active[k]].a, b = c.history[c.active[k]].b;
    const int slotA = bodies.slots[cellOf(world, a)], slotB = bodies.slots[cellOf(world, b)];
    const double limit = *c.parameters.releaseDistance * (radius(bodies, slotA) + radius(bodies, slotB));
    if (norm(measureCentre(bodies, slotA) - measureCentre(bodies, slotB)) > limit)
      release(c, a, b, world.clock.time, "distance");
  }
}

}  // namespace morula

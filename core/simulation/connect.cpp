// Connections by gene, and their end by distance [Nilsson 2008, §4.1.1, §4.4.3].
#include <algorithm>
#include <numbers>

#include "base/maths.h"
#include "simulation/population.h"
#include "simulation/stages.h"

namespace morula {

namespace {

/// Of the sphere that holds the cell's volume.
double radius(const Bodies& b, int slot) { return cubeRoot(3 * b.volume[slot] / (4 * std::numbers::pi)); }

}  // namespace

void connectByGene(World& world, const Observation& now, const std::vector<CellChange>& changes) {
  if (!world.connections || world.connections->parameters.make == MakeConnections::atDivision) return;
  Connections& connections = *world.connections;
  const auto cycled = [&](int cell) {
    return changes[cell] != CellChange::none && changes[cell] != CellChange::dies;
  };
  const auto wish = [&](int cell) { return world.biology->wantsToConnect(ObservedCell(now, cell)); };

  const auto active = connections.active;  // release changes the list
  for (std::size_t i : active) {
    const auto& [a, b] = std::pair{connections.history[i].a, connections.history[i].b};
    const int cellA = cellNumber(world.cells, a), cellB = cellNumber(world.cells, b);
    if ((cycled(cellA) || cycled(cellB)) && wish(cellA) + wish(cellB) < 0)
      release(connections, a, b, world.clock.time, "gene");
  }
  for (const ContactArea& touch : now.contacts())
    if ((cycled(touch.a) || cycled(touch.b)) && wish(touch.a) + wish(touch.b) > 0)
      connect(connections, world.cells.path[touch.a], world.cells.path[touch.b], world.clock.time);
}

void releaseConnections(World& world) {
  if (!world.connections || !world.connections->parameters.releaseDistance) return;
  Connections& c = *world.connections;
  const Bodies& bodies = *world.bodies;
  for (std::size_t k = c.active.size();
       k-- > 0;) {  // from behind, for release takes the pair out of the list
    const CellPath a = c.history[c.active[k]].a, b = c.history[c.active[k]].b;
    const int slotA = bodies.slots[cellNumber(world.cells, a)],
              slotB = bodies.slots[cellNumber(world.cells, b)];
    const double limit = *c.parameters.releaseDistance * (radius(bodies, slotA) + radius(bodies, slotB));
    if (norm(measureCentre(bodies, slotA) - measureCentre(bodies, slotB)) > limit)
      release(c, a, b, world.clock.time, "distance");
  }
}

}  // namespace morula

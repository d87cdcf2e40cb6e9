// Connections by gene, and their end by distance [Nilsson 2008, §4.1.1, §4.4.3].
#include <algorithm>

#include "base/maths.h"
#include "simulation/body_unit.h"
#include "simulation/population.h"
#include "simulation/stages.h"

namespace morula {

namespace {

double wantsToConnect(const World& world, int slot) {
  const BodyUnit body(*world.bodies, slot);
  return world.biology->wantsToConnect({world.cells.path[slot], world.cells.state[slot], world.clock.time,
                                        world.cells.lastCycle[slot], &body});
}

/// Of the sphere that holds the cell's volume.
double radius(const Bodies& b, int slot) { return cubeRoot(3 * b.volume[slot] / 12.566370614359172); }

}  // namespace

void connectByGene(World& world, const std::vector<CellChange>& changes) {
  if (!world.connections || world.connections->parameters.make == MakeConnections::atDivision) return;
  Connections& connections = *world.connections;
  const double time = world.clock.time;
  const auto cycled = [&](int slot) {
    return changes[slot] != CellChange::none && changes[slot] != CellChange::dies;
  };

  const auto active = connections.active;  // release changes the list
  for (std::size_t i : active) {
    const auto& [a, b] = std::pair{connections.history[i].a, connections.history[i].b};
    const auto slotOf = [&](const CellPath& p) {
      return static_cast<int>(std::lower_bound(world.cells.path.begin(), world.cells.path.end(), p) -
                              world.cells.path.begin());
    };
    const int slotA = slotOf(a), slotB = slotOf(b);
    if ((cycled(slotA) || cycled(slotB)) && wantsToConnect(world, slotA) + wantsToConnect(world, slotB) < 0)
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
  const auto& paths = world.cells.path;
  for (std::size_t k = c.active.size(); k-- > 0;) {  // from behind, for release takes the pair out of the list
    const CellPath a = c.history[c.active[k]].a, b = c.history[c.active[k]].b;
    const int slotA = static_cast<int>(std::lower_bound(paths.begin(), paths.end(), a) - paths.begin());
    const int slotB = static_cast<int>(std::lower_bound(paths.begin(), paths.end(), b) - paths.begin());
    const double limit = *c.parameters.releaseDistance * (radius(bodies, slotA) + radius(bodies, slotB));
    if (norm(measureCentre(bodies, slotA) - measureCentre(bodies, slotB)) > limit)
      release(c, a, b, world.clock.time, "distance");
  }
}

}  // namespace morula

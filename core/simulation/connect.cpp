// Makes and releases connections between neighbours, and ends them by distance, tension and age [Nilsson 2008, §4.1.1,
// §4.4.3].
#include "simulation/connect.h"

#include <algorithm>
#include <tuple>

#include "biology/substance_pattern.h"
#include "simulation/population.h"

namespace morula {
namespace {

/// Returns true if one cell holds a substance of one side of the pair, and the other cell one of the pair's other side.
bool fits(const ConnectedPair& pair, const std::string& one, const std::string& other) {
  return (fitsAny(pair.a, one) && fitsAny(pair.b, other)) || (fitsAny(pair.b, one) && fitsAny(pair.a, other));
}

/// Returns true if two cells that touch get a connection. `wish`: the sum of their wantsToConnect.
bool shallConnect(const ConnectionParameters& p, double wish, const CellContext& a, const CellContext& b) {
  if (p.make == MakeConnections::byContact) return wish >= 0;
  if (p.make != MakeConnections::pairs) return wish > 0;
  const std::string ofA = a.substances(), ofB = b.substances();
  return wish >= 0 && std::ranges::any_of(p.pairs, [&](const ConnectedPair& pair) { return fits(pair, ofA, ofB); });
}

}  // namespace

void connectNeighbours(World& world, const Observation& now, const std::vector<CellChange>& changes) {
  if (!world.connections || world.connections->parameters.make == MakeConnections::atDivision) return;
  Connections& connections = *world.connections;
  const auto cycled = [&](int cell) { return changes[cell] != CellChange::none && changes[cell] != CellChange::dies; };
  const auto wish = [&](int cell) { return world.biology->wantsToConnect(ObservedCell(now, cell)); };

  const auto active = connections.active;  // release changes the list
  for (std::size_t i : active) {
    const auto& [a, b] = std::pair{connections.history[i].a, connections.history[i].b};
    const int cellA = cellNumber(world.cells, a), cellB = cellNumber(world.cells, b);
    if ((cycled(cellA) || cycled(cellB)) && wish(cellA) + wish(cellB) < 0)
      release(connections, a, b, world.clock.time, ReleaseCause::gene);
  }
  for (const ContactArea& touch : now.contacts())
    if ((cycled(touch.a) || cycled(touch.b)) && shallConnect(connections.parameters, wish(touch.a) + wish(touch.b),
                                                             ObservedCell(now, touch.a), ObservedCell(now, touch.b)))
      connect(connections, world.cells.path[touch.a], world.cells.path[touch.b], world.clock.time);
}

void releaseConnections(World& world) {
  if (!world.connections) return;
  Connections& c = *world.connections;
  const auto& [releaseDistance, releaseTension, releaseAge] =
      std::tie(c.parameters.releaseDistance, c.parameters.releaseTension, c.parameters.releaseAge);
  if (!releaseDistance && !releaseTension && !releaseAge) return;
  const Bodies& bodies = *world.bodies;
  for (std::size_t k = c.active.size(); k-- > 0;) {  // from behind, for release takes the pair out of the list
    const auto [a, b, made, released, none] = c.history[c.active[k]];
    const int slotA = bodies.slots[cellNumber(world.cells, a)], slotB = bodies.slots[cellNumber(world.cells, b)];
    const double distance = norm(measureCentre(bodies, slotA) - measureCentre(bodies, slotB));
    auto cause = ReleaseCause::none;
    if (releaseDistance && distance > *releaseDistance * (roundRadius(bodies, slotA) + roundRadius(bodies, slotB)))
      cause = ReleaseCause::distance;
    else if (releaseTension && springTension(*c.parameters.spring, bodies, slotA, slotB, distance) > *releaseTension)
      cause = ReleaseCause::tension;
    else if (releaseAge && world.clock.time - made >= *releaseAge) cause = ReleaseCause::age;
    if (cause != ReleaseCause::none) release(c, a, b, world.clock.time, cause);
  }
}

}  // namespace morula

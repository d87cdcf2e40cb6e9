// [Nilsson 2008, eq. 4.9] f_c = k_c v̂.
#include <algorithm>

#include "connections/connections.h"

namespace morula {

namespace {

/// Spreads a force over all vertices of a cell.
void addToVertices(Bodies& bodies, int slot, const Vector& force) {
  for (int v = 0; v < bodies.vertexCount(slot); ++v)
    bodies.write(bodies.acceleration, slot, v, bodies.read(bodies.acceleration, slot, v) + force);
}

}  // namespace

void addConnectionForces(const Connections& c, const std::vector<CellPath>& paths, Bodies& bodies) {
  const auto slotOf = [&](const CellPath& path) {
    return bodies.slots[std::lower_bound(paths.begin(), paths.end(), path) - paths.begin()];
  };
  for (std::size_t i : c.active) {
    const int a = slotOf(c.history[i].a), b = slotOf(c.history[i].b);
    const Vector between = measureCentre(bodies, b) - measureCentre(bodies, a);
    const double distance = norm(between);
    if (!(distance > 0)) continue;  // concentric: no direction, no force
    const auto share = [&](int slot) {
      return (c.parameters.strength / (distance * bodies.vertexCount(slot))) * between;
    };
    addToVertices(bodies, a, share(a));
    addToVertices(bodies, b, -share(b));
  }
}

}  // namespace morula

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

/// [1] Of the egg's mass or of its volume at rest, whichever is the smaller share, and no more than all of
/// it.
double shareOfEgg(const Bodies& b, int slot) {
  const double scale = b.restScale[slot];
  return std::min({1.0, b.mass(slot) / b.parameters.cell.mass, scale * scale * scale});
}

}  // namespace

void addConnectionForces(Connections& c, const std::vector<CellPath>& paths, Bodies& bodies) {
  const auto cellOf = [&](const CellPath& path) {
    return std::lower_bound(paths.begin(), paths.end(), path) - paths.begin();
  };
  const bool shared = !c.parameters.strength;
  if (shared) {
    c.count.assign(paths.size(), 0);
    for (std::size_t i : c.active) ++c.count[cellOf(c.history[i].a)], ++c.count[cellOf(c.history[i].b)];
  }
  const auto part = [&](std::ptrdiff_t cell) {
    return sharedStrength * shareOfEgg(bodies, bodies.slots[cell]) / c.count[cell];
  };
  for (std::size_t i : c.active) {
    const auto first = cellOf(c.history[i].a), second = cellOf(c.history[i].b);
    const int a = bodies.slots[first], b = bodies.slots[second];
    const Vector between = measureCentre(bodies, b) - measureCentre(bodies, a);
    const double distance = norm(between);
    if (!(distance > 0)) continue;  // concentric: no direction, no force
    const double pull = shared ? std::min(part(first), part(second)) : *c.parameters.strength;
    const auto share = [&](int slot) { return (pull / (distance * bodies.vertexCount(slot))) * between; };
    addToVertices(bodies, a, share(a));
    addToVertices(bodies, b, -share(b));
  }
}

}  // namespace morula

// [Nilsson 2008, eq. 4.9] f_c = k_c v̂; with a spring k_c = k (|v| − rest).
#include <algorithm>
#include <numbers>

#include "base/maths.h"
#include "base/parallel.h"
#include "connections/connections.h"

namespace morula {
namespace {

/// Returns the cell's share [1] of the egg: of its mass or of its volume at rest, whichever is smaller, at most 1.
double shareOfEgg(const Bodies& b, int slot) {
  const double scale = b.restScale[slot];
  return std::min({1.0, b.mass(slot) / b.parameters.cell.mass, scale * scale * scale});
}

/// Finds the cells of each connection and the connections of each cell, in the order of the active connections.
void findEnds(ConnectionScratch& scratch, const Connections& c, const std::vector<CellPath>& paths) {
  const auto cellOf = [&](const CellPath& path) {
    return static_cast<int>(std::lower_bound(paths.begin(), paths.end(), path) - paths.begin());
  };
  scratch.ends.clear();
  for (std::size_t i : c.active) scratch.ends.push_back({cellOf(c.history[i].a), cellOf(c.history[i].b)});
  scratch.first.assign(paths.size() + 1, 0);
  for (const auto& [a, b] : scratch.ends) ++scratch.first[a + 1], ++scratch.first[b + 1];
  for (std::size_t cell = 0; cell < paths.size(); ++cell) scratch.first[cell + 1] += scratch.first[cell];
  scratch.ofCell.resize(2 * scratch.ends.size());
  scratch.next.assign(scratch.first.begin(), scratch.first.end() - 1);
  for (std::size_t i = 0; i < scratch.ends.size(); ++i)
    for (const int cell : scratch.ends[i]) scratch.ofCell[scratch.next[cell]++] = static_cast<int>(i);
}

}  // namespace

double roundRadius(const Bodies& b, int slot) { return cubeRoot(3 * b.volume[slot] / (4 * std::numbers::pi)); }

double springTension(const ConnectionSpring& spring, const Bodies& b, int slotA, int slotB, double distance) {
  // Radii at rest do not depend on where vertices are, so the spring's force is all that its energy asks for.
  const double radii = b.parameters.cell.radius * (b.restScale[slotA] + b.restScale[slotB]);
  return spring.stiffness * (distance - spring.rest * radii);
}

namespace {

/// Returns the pull [force] of the active connection number `i` over a distance.
class Pulls {
 public:
  Pulls(const Connections& c, const Bodies& b) : c_(c), b_(b) {}
  double operator()(std::size_t i, double distance) const {
    const auto& [a, b] = c_.scratch.ends[i];
    if (c_.parameters.spring) return springTension(*c_.parameters.spring, b_, b_.slots[a], b_.slots[b], distance);
    return c_.parameters.strength ? *c_.parameters.strength : std::min(part(a), part(b));
  }
  int countOf(int cell) const { return c_.scratch.first[cell + 1] - c_.scratch.first[cell]; }

 private:
  double part(int cell) const { return sharedStrength * shareOfEgg(b_, b_.slots[cell]) / countOf(cell); }
  const Connections& c_;
  const Bodies& b_;
};

}  // namespace

void addConnectionForces(Connections& c, const std::vector<CellPath>& paths, Bodies& bodies, int threads) {
  c.isCurrent = true;
  ConnectionScratch& scratch = c.scratch;
  findEnds(scratch, c, paths);
  const int cells = static_cast<int>(paths.size());
  const Pulls pullOf(c, bodies);
  scratch.centre.resize(paths.size());
  parallelFor(cells, threads, [&](int cell) {
    if (pullOf.countOf(cell) > 0) scratch.centre[cell] = measureCentre(bodies, bodies.slots[cell]);
  });
  // Each cell gathers its own forces, one connection after the other, so that threads cannot matter.
  parallelFor(cells, threads, [&](int cell) {
    const int slot = bodies.slots[cell], vertices = bodies.vertexCount(slot);
    for (int k = scratch.first[cell]; k < scratch.first[cell + 1]; ++k) {
      const std::size_t i = scratch.ofCell[k];
      const auto& [a, b] = scratch.ends[i];
      const Vector between = scratch.centre[b] - scratch.centre[a];
      const double distance = norm(between);
      if (!(distance > 0)) continue;  // concentric: no direction, no force
      const double pull = pullOf(i, distance);
      const Vector share = (pull / (distance * vertices)) * between;
      const Vector force = cell == a ? share : -share;
      for (int v = 0; v < vertices; ++v)
        bodies.write(bodies.acceleration, slot, v, bodies.read(bodies.acceleration, slot, v) + force);
    }
  });
}

double measureConnectionEnergy(const Connections& connections, const std::vector<CellPath>& paths, const Bodies& b) {
  Connections c = connections;
  findEnds(c.scratch, c, paths);
  const Pulls pullOf(c, b);
  double sum = 0;
  for (std::size_t i = 0; i < c.scratch.ends.size(); ++i) {
    const auto& [first, second] = c.scratch.ends[i];
    const double distance = norm(measureCentre(b, b.slots[second]) - measureCentre(b, b.slots[first])),
                 pull = pullOf(i, distance);
    sum += c.parameters.spring ? 0.5 * pull * pull / c.parameters.spring->stiffness : pull * distance;
  }
  return sum;
}

}  // namespace morula

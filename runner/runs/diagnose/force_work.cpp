#include "diagnose/force_work.h"

#include <algorithm>

namespace morula {

WorkMeter::WorkMeter(World& world, const CellPath& cell)
    : cell_(cell), before_(positions(world)), forces_(measureForces(world, slotIn(world))) {
  for (const VertexForces& f : forces_) works_.push_back({f.name, 0});
}

int WorkMeter::slotIn(const World& world) const {
  const auto& paths = world.cells.path;
  return world.bodies->slots[std::lower_bound(paths.begin(), paths.end(), cell_) - paths.begin()];
}

std::vector<Point> WorkMeter::positions(const World& world) const {
  const int slot = slotIn(world);
  std::vector<Point> points;
  for (int v = 0; v < world.bodies->vertexCount(slot); ++v) points.push_back(world.bodies->vertex(slot, v));
  return points;
}

void WorkMeter::observe(World& world) {
  const std::vector<Point> now = positions(world);
  std::vector<VertexForces> forces = measureForces(world, slotIn(world));
  for (std::size_t f = 0; f < forces.size(); ++f)
    for (std::size_t v = 0; v < now.size(); ++v)
      works_[f].work += 0.5 * dot(forces_[f].onVertex[v] + forces[f].onVertex[v], now[v] - before_[v]);
  before_ = now;
  forces_ = std::move(forces);
}

std::vector<ForceWork> WorkMeter::works() const {
  std::vector<ForceWork> sorted = works_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const ForceWork& a, const ForceWork& b) { return a.work > b.work; });
  return sorted;
}

}  // namespace morula

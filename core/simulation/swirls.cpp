
#include "simulation/swirls.h"

#include <numbers>

#include "base/maths.h"
#include "base/parallel.h"
#include "state/world.h"

namespace morula {
namespace {

constexpr double lifetime = 8;  // [time constant] after which a swirl ends

/// Returns the division in which a young cell was born, so one of the last; null: none made it.
const DivisionRecord* divisionOf(const World& world, const CellPath& mother) {
  for (auto i = world.divisions.rbegin(); i != world.divisions.rend(); ++i)
    if (i->path == mother) return &*i;
  return nullptr;
}

void addSwirl(World& world, int cell, std::span<const std::uint32_t> order) {
  const CellPath& path = world.cells.path[cell];
  const double born = world.lineage.entries[world.cells.entry[cell]].born, age = world.clock.time - born;
  const DivisionParameters& parameters = world.model.mechanics->division;
  if (path.isEgg() || age > lifetime * longestChirality(parameters)) return;
  const DivisionRecord* division = divisionOf(world, path.mother());
  const LineageEntry* mother = find(world.lineage, order, path.mother());
  if (!division || !mother) return;
  const auto chirality = chiralityOf(parameters, mother->path, world.biology->describe(mother->state));
  if (!chirality || age > lifetime * chirality->time) return;
  const bool isB = path.letter(path.depth() - 1);
  const double angle = chirality->angle * (std::numbers::pi / 180);
  world.swirls->push_back({cell, division->axis, (isB ? -angle : angle) / chirality->time, chirality->time, born});
}

}  // namespace

void findSwirls(World& world) {
  if (!world.model.mechanics || longestChirality(world.model.mechanics->division) == 0) return;
  world.swirls.emplace();
  const std::vector<std::uint32_t> order = orderByPath(world.lineage);
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) addSwirl(world, static_cast<int>(i), order);
}

void addSwirlForces(World& world) {
  Bodies& bodies = *world.bodies;
  const std::vector<Swirl>& swirls = *world.swirls;
  parallelFor(static_cast<int>(swirls.size()), world.execution.threads, [&](int i) {
    const Swirl& swirl = swirls[i];
    const double age = world.clock.time - swirl.born;
    if (age > lifetime * swirl.time) return;
    const int slot = bodies.slots[swirl.cell];
    const Vector turn = (swirl.rate * exponential(-age / swirl.time)) * swirl.axis;
    const Vector forcePerLength = (bodies.vertexMass[slot] * bodies.parameters.drag) * turn;
    const Point centre = measureCentre(bodies, slot);
    for (int v = 0; v < bodies.vertexCount(slot); ++v) {
      const Vector force = cross(forcePerLength, bodies.vertex(slot, v) - centre);
      bodies.write(bodies.acceleration, slot, v, bodies.read(bodies.acceleration, slot, v) + force);
    }
  });
}

}  // namespace morula

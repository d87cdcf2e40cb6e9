
#include "simulation/motility.h"

#include <cmath>

#include "base/parallel.h"
#include "base/random.h"
#include "state/world.h"

namespace morula {

void addMotility(World& world) {
  const PhysicsParameters& p = world.model.mechanics->physics;
  Motility& m = *world.motility;
  Bodies& bodies = *world.bodies;
  const int cells = static_cast<int>(world.cells.path.size()), threads = world.execution.threads;
  // Beyond 2^53 the quotient is no longer exact, and no run comes so far.
  const auto interval = static_cast<std::uint64_t>(std::floor(world.clock.time / p.motility->persistence));
  if (!m.isCurrent || m.interval != interval) {
    m.direction.resize(world.cells.path.size());
    parallelFor(cells, threads, [&](int cell) {
      m.direction[cell] = randomDirection(
          {world.model.seed, world.cells.path[cell], static_cast<std::uint32_t>(interval), Purpose::motility});
    });
    m.interval = interval;
    m.isCurrent = true;
  }
  parallelFor(cells, threads, [&](int cell) {
    const int slot = bodies.slots[cell], vertices = bodies.vertexCount(slot);
    const Vector force = (bodies.vertexMass[slot] * p.drag * p.motility->speed) * m.direction[cell];
    for (int v = 0; v < vertices; ++v)
      bodies.write(bodies.acceleration, slot, v, bodies.read(bodies.acceleration, slot, v) + force);
  });
}

}  // namespace morula

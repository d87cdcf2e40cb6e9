#include "bench/stir.h"

#include <cmath>

#include "base/random.h"

namespace morula {

void stir(World& world) {
  Bodies& b = *world.bodies;
  const double edge = b.mesh.meanRestLength * b.restScale[0];
  const double wanted = stirredMove * edge / world.clock.timeStep;
  double squares = 0;
  for (int slot = 0; slot < b.count; ++slot) {
    const Vector push =
        wanted * randomDirection({0, world.cells.path[slot], static_cast<std::uint32_t>(world.clock.step),
                                  Purpose::perturbation});
    for (int v = 0; v < b.vertexCount(); ++v) {
      const Vector now = b.read(b.velocity, slot, v) + push;
      b.write(b.velocity, slot, v, now);
      squares += dot(now, now);
    }
  }
  const double scale = wanted / std::sqrt(squares / (double(b.count) * b.vertexCount()));
  for (std::size_t i = 0; i < b.velocity.size(); ++i) b.velocity[i] = scale * b.velocity[i];
}

}  // namespace morula

#include "loop/twin_run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "simulation/hash.h"
#include "simulation/world.h"

namespace morula {

namespace {

constexpr std::array decades{1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8,
                             1e-7,  1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1, 1.0};
constexpr double infinity = std::numeric_limits<double>::infinity();

void moveByOneUlp(Bodies& bodies) {
  const double x = bodies.position[bodies.at(0, 0)];
  bodies.position[bodies.at(0, 0)] =
      bodies.parameters.precision == Precision::binary64
          ? std::nextafter(x, infinity)
          : double(std::nextafter(float(x), std::numeric_limits<float>::infinity()));
}

double distance(const World& a, const World& b) {
  if (a.cells.path != b.cells.path || a.bodies->position.size() != b.bodies->position.size()) return infinity;
  const Reals &p = a.bodies->position, &q = b.bodies->position;  // cells stand in the same places
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) largest = std::max(largest, std::abs(p[i] - q[i]));
  return largest;
}

/// False where the run cannot go on.
bool advance(World& world) {
  try {
    step(world);
    return true;
  } catch (const NumericalError&) { return false; }
}

}  // namespace

TwinRun runTwins(World world, World twin, const std::function<void(const World&)>& watch) {
  CHECK(world.bodies && world.clock.step == 0, "twins are born at step 0, with bodies");
  moveByOneUlp(*twin.bodies);
  const double radius = world.model.mechanics->physics.cell.radius;
  TwinRun run;
  std::size_t next = 0;
  while (!finished(world)) {
    if (watch) watch(world);
    const bool bothLive = advance(world) & advance(twin);
    const double apart = bothLive ? distance(world, twin) / radius : infinity;
    for (; next < decades.size() && apart >= decades[next]; ++next)
      run.growth.push_back({decades[next], world.clock.step});
    if (!bothLive) break;
  }
  run.end = hashState(world).whole;
  return run;
}

}  // namespace morula

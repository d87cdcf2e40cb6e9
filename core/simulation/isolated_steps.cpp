// Isolated cells: where no force acts between them, a block goes through many time steps while it is in cache.
#include <algorithm>
#include <atomic>

#include "base/parallel.h"
#include "simulation/settle.h"
#include "simulation/stages.h"

namespace morula {
namespace {

bool areIsolated(const World& world) {
  return world.bodies && !settles(world) && !world.contacts && !world.connections && !world.motility && !world.swirls &&
         std::all_of(world.cells.growth.begin(), world.cells.growth.end(), [](double g) { return g == 0; });
}

/// False if a cell did not stay sound; the bodies are then as they were.
bool moveIsolated(World& world, std::uint64_t steps) {
  Bodies& b = *world.bodies;
  if (!world.before) world.before.emplace();
  BodyCopy& before = *world.before;
  before.position = b.position, before.velocity = b.velocity, before.acceleration = b.acceleration;
  std::atomic<bool> sound = true;
  parallelFor(b.blockCount(), world.execution.threads, [&](int i) {
    const BlockView block = b.block(i, threadNumber());
    if (!stepIsolatedCells(world.stagesOfLanes[block.liveLanes - 1], b, block, world.clock.timeStep, steps))
      sound = false;
  });
  if (sound) return true;
  std::swap(b.position, before.position);
  std::swap(b.velocity, before.velocity);
  std::swap(b.acceleration, before.acceleration);
  return false;
}

/// Of the clock's own length: a shorter last one is made by itself.
std::uint64_t wholeStepsUntilEnd(const World& world) {
  const std::uint64_t steps = stepsUntil(world.clock, plannedStop(world));
  if (world.bodies->parameters.timeStep || steps == 1) return steps;
  return endsLate(world, steps) ? steps - 1 : steps;
}

}  // namespace

std::uint64_t stepsUntil(const Clock& clock, double time) {
  if (clock.timeStep == 0) return 1;
  const double missing = (time - clock.time) / clock.timeStep;
  if (!(missing < 1e15)) return std::uint64_t(1) << 50;
  auto steps = static_cast<std::uint64_t>(std::max(1.0, missing));
  // The quotient may be off by its rounding; what the clock will show decides.
  while (steps > 1 && timeAfter(clock, steps - 1) >= time) --steps;
  while (timeAfter(clock, steps) < time) ++steps;
  return steps;
}

void takeSteps(World& world, std::uint64_t most) {
  Clock& clock = world.clock;
  std::uint64_t steps = 1;
  if (areIsolated(world)) steps = std::min({most, stepsUntil(clock, clock.nextCycle), wholeStepsUntilEnd(world)});
  if (steps <= 1) return step(world);
  const double before = clock.time;
  if (!moveIsolated(world, steps)) {
    for (; steps > 0; --steps) step(world);  // one of which says what is wrong
    return;
  }
  clock.time = timeAfter(clock, steps);
  clock.step += steps;
  runCellCycles(world, before, dueUntil(world, before));
}

}  // namespace morula

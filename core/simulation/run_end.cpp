
#include "simulation/run_end.h"

#include <algorithm>
#include <cmath>

#include "simulation/simulation.h"

namespace morula {
namespace {

// Relative tolerance. A sum of k cycle lengths may differ from their product by rounding, and a stop at cycle k must
// still run cycle k.
constexpr double slack = 1e-9;

/// Returns the latest time [time] of a cell cycle that the run still makes; infinite without a planned end.
double lastDue(const Scene& scene) {
  const std::optional<double> end = plannedEnd(scene);
  return end ? *end + slack * scene.cycle.length : INFINITY;
}

}  // namespace

double timeAfter(const Clock& clock, std::uint64_t steps) {
  return clock.epochTime + static_cast<double>(clock.step + steps - clock.epochStep) * clock.timeStep;
}

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

bool finished(const World& world) {
  if (world.cells.path.empty() || hasEnoughCells(world) || world.stoppedBy) return true;
  if (world.bodies) return world.clock.time >= plannedStop(world);
  return world.clock.nextCycle > lastDue(world.model);
}

bool hasEnoughCells(const World& world) {
  const auto& most = world.model.stop.cells;
  return most && world.cells.path.size() >= *most;
}

double dueUntil(const World& world, double before) {
  if (!world.bodies) return world.clock.time;
  const double stop = plannedStop(world);
  return before < stop && world.clock.time >= stop ? lastDue(world.model) : world.clock.time;
}

double nextStepLength(const World& world) {
  const Clock& clock = world.clock;
  if (world.bodies->parameters.timeStep || !(clock.time < plannedStop(world)) || !endsLate(world, 1))
    return clock.timeStep;
  return *plannedEnd(world.model) - clock.time;
}

bool endsLate(const World& world, std::uint64_t steps) {
  const std::optional<double> end = plannedEnd(world.model);
  return end && timeAfter(world.clock, steps) > *end * (1 + slack);
}

double plannedStop(const World& world) {
  const std::optional<double> end = plannedEnd(world.model);
  return end ? *end * (1 - slack) : INFINITY;
}

}  // namespace morula

#include "simulation/settle.h"

#include <algorithm>
#include <cmath>

#include "physics/integrator.h"
#include "simulation/cell_cycles.h"
#include "simulation/connect.h"
#include "simulation/cycle_lengths.h"
#include "simulation/damped_motion.h"
#include "simulation/experiments.h"
#include "simulation/move_physics.h"
#include "simulation/rest.h"
#include "simulation/run_end.h"
#include "simulation/simulation.h"

namespace morula {
namespace {

// Drag [1/shortest cycle]. Few cells need more than many, or a division would throw them all over the organism; and
// motion that is left comes to rest in the last share of the time to an event.
constexpr double usualCells = 128, mostDrag = 40, coolingDrag = 35, coolingShare = 0.13;

// A run's last settling to a residual: drag [1] on the way downhill, and max length [shortest cycle].
constexpr double lastDrag = 0.01, mostCycles = 1000;

/// Returns the time [time] of the next cell cycle, or where cells grow of the next part of their growth.
double nextCycle(const World& world) {
  const Clock& clock = world.clock;
  const PhysicsParameters& p = world.bodies->parameters;
  double next = clock.nextCycle > clock.time ? clock.nextCycle + p.quasiStatic.together : INFINITY;
  if (p.growth) {
    double fastest = 0;
    for (double growth : world.cells.growth) fastest = std::max(fastest, std::abs(growth));
    // Cells that wait for a size are asked as often as if they grew.
    if (fastest > 0 || next == INFINITY)
      next = std::min(next, clock.time + maxGrowth / (p.growth->rate * std::max(fastest, 1.0)));
  }
  return next;
}

/// Returns the time [time] of the next event.
double nextEvent(const World& world) {
  const double experiment = std::max(world.clock.time, nextExperiment(world));
  return std::min({nextCycle(world), plannedEnd(world.model).value_or(INFINITY), experiment});
}

/// Returns a^(1/5), to within 2 ulp: Newton's iteration from above falls all the way.
double fifthRoot(double a) {
  double x = std::max(a, 1.0);
  for (double next = x; (next = x - (x - a / (x * x * x * x)) / 5) < x;) x = next;
  return x;
}

int mostVertices(const Bodies& bodies) {
  int most = 1;
  for (int slot : bodies.slots) most = std::max(most, bodies.vertexCount(slot));
  return most;
}

double evaluationsPerCycle(const World& world) {
  return evaluationsPerTime(world.model, mostVertices(*world.bodies)) * shortestCycle(world.model.cycle).length;
}

/// Settles for the time until the next cell cycle, whatever stops the run before it: other runs may go on from here.
void settle(World& world) {
  if (world.bodies->count == 0) return;
  const QuasiStaticParameters& p = world.bodies->parameters.quasiStatic;
  const double cycle = shortestCycle(world.model.cycle).length, perCycle = evaluationsPerCycle(world);
  const double perTime = perCycle / cycle;
  const double until = std::min(nextCycle(world), world.clock.time + cycle);
  const auto evaluationsBefore = [&](double time) { return std::floor(time * perTime); };
  const double count = std::max(0.0, evaluationsBefore(until) - evaluationsBefore(world.clock.time));
  const double drag = std::min(mostDrag, p.drag * fifthRoot(usualCells / world.bodies->count));
  SettlingRecord record{.time = world.clock.time, .step = world.clock.step, .cells = world.cells.path.size()};
  if (count > 0) {
    DampedMotion motion(world, cycle / perCycle);
    const double cooled = std::floor(coolingShare * count);
    motion.go(drag / perCycle, static_cast<std::uint64_t>(count - cooled));
    motion.go(std::max(drag, coolingDrag) / perCycle, static_cast<std::uint64_t>(cooled));
    record.energyLeft = motion.energy();
  }
  record.evaluations = static_cast<std::uint64_t>(count);
  record.residual = measureResidual(world);
  world.settlings->push_back(record);
}

}  // namespace

bool settles(const World& world) { return world.bodies && kindOf(world.bodies->parameters.integrator).settles; }

double evaluationsPerTime(const Scene& scene, int vertices) {
  const double perCycle = scene.mechanics->physics.quasiStatic.evaluations * std::sqrt(double(vertices));
  return perCycle / shortestCycle(scene.cycle).length;
}

void stepQuasiStatic(World& world) {
  Clock& clock = world.clock;
  const double before = clock.time;
  const double due = clock.nextCycle;
  const std::size_t done = world.experiments ? world.experiments->size() : 0;
  bool isEvent = true;
  if (clock.step++ > 0) {
    clock.time = nextEvent(world);
    growCells(world, clock.time - before);
    releaseConnections(world);
    runEvents(world, before, dueUntil(world, before));
    const bool grows = std::ranges::any_of(world.cells.growth, [](double rate) { return rate != 0; });
    isEvent = grows || clock.nextCycle != due || (world.experiments && world.experiments->size() != done);
  }
  if (isEvent) settle(world);
}

void settleEnd(World& world) {
  if (!settles(world)) return;
  if (world.bodies->count == 0 || world.settlings->empty() || !finished(world)) return;
  const Bodies& bodies = *world.bodies;
  const auto& residual = bodies.parameters.quasiStatic.residual;
  const double perCycle = evaluationsPerCycle(world);
  SettlingRecord& record = world.settlings->back();
  DampedMotion motion(world, shortestCycle(world.model.cycle).length / perCycle);
  const auto cooled = static_cast<std::uint64_t>(coolingShare * perCycle);
  motion.go(coolingDrag / perCycle, cooled);
  record.evaluations += cooled;
  if (residual) {
    const Reals before = bodies.position;
    const auto most = static_cast<std::uint64_t>(mostCycles * perCycle);
    record.evaluations += motion.goToRest(lastDrag, *residual, most);
    double farthest = 0;
    for (int slot : bodies.slots)
      for (int v = 0; v < bodies.vertexCount(slot); ++v)
        farthest = std::max(farthest, norm(bodies.vertex(slot, v) - bodies.read(before, slot, v)));
    record.displacementLeft = farthest;
  }
  record.energyLeft = motion.energy();
  record.residual = measureResidual(world);
}

}  // namespace morula

// One step of a world: the stages of the thesis' figures 4.2 and 4.4. A block of isolated cells, on which no other
// cells act, goes through many time steps while it is in cache.
#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "base/parallel.h"
#include "contacts/contacts.h"
#include "physics/growth.h"
#include "physics/sag.h"
#include "simulation/cell_cycles.h"
#include "simulation/check_bodies.h"
#include "simulation/connect.h"
#include "simulation/experiments.h"
#include "simulation/memory.h"
#include "simulation/move_physics.h"
#include "simulation/run_end.h"
#include "simulation/settle.h"
#include "simulation/simulation.h"
#include "simulation/stop_when.h"
#include "simulation/time_step.h"

namespace morula {
namespace {

bool areIsolated(const World& world) {
  return world.bodies && !settles(world) && !world.contacts && !world.connections && !world.motility && !world.swirls &&
         std::all_of(world.cells.growth.begin(), world.cells.growth.end(), [](double g) { return g == 0; });
}

/// Returns false if a cell did not stay sound; the bodies are then as they were.
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

/// Returns the number of steps of the clock's own length; a shorter last step is made by itself.
std::uint64_t wholeStepsUntilEnd(const World& world) {
  const std::uint64_t steps = stepsUntil(world.clock, plannedStop(world));
  if (world.bodies->parameters.timeStep || steps == 1) return steps;
  return endsLate(world, steps) ? steps - 1 : steps;
}

/// The last step before the planned end may be shorter. While this object exists the clock has that shorter time step;
/// then the usual one is restored, because a run may be continued to a later end.
class LastStep {
 public:
  explicit LastStep(World& world) : clock_(world.clock), usual_(clock_.timeStep) {
    const double length = nextStepLength(world);
    if (length != usual_) begin(length);
  }
  ~LastStep() {
    if (clock_.timeStep != usual_) begin(usual_);
  }
  LastStep(const LastStep&) = delete;
  LastStep& operator=(const LastStep&) = delete;

 private:
  void begin(double timeStep) {
    clock_.timeStep = timeStep;
    clock_.epochTime = clock_.time;
    clock_.epochStep = clock_.step;
  }
  Clock& clock_;
  double usual_;
};

}  // namespace

void step(World& world) {
  Clock& clock = world.clock;
  const BeforeStep before(world);
  if (settles(world)) {
    stepQuasiStatic(world);
    lookForStop(world, before);
    return settleEnd(world);
  }
  if (world.bodies) {
    const LastStep last(world);
    ++clock.step;
    clock.time = timeAfter(clock, 0);
    growCells(world, clock.timeStep);
    movePhysics(world, clock.timeStep);
    checkBodies(world);
    checkCrossing(world);
    releaseConnections(world);
  } else {
    ++clock.step;
    clock.time = std::min(clock.nextCycle, std::max(before.clockTime, nextExperiment(world)));
  }
  runEvents(world, before.clockTime, dueUntil(world, before.clockTime));
  // Connections that this step has made or released pull, or pull no more, from its end on.
  if (world.connections && !world.connections->isCurrent) evaluateForces(world);
  followContacts(world);
  lookForStop(world, before);
}

void takeSteps(World& world, std::uint64_t most) {
  Clock& clock = world.clock;
  std::uint64_t steps = 1;
  if (areIsolated(world))
    steps = std::min({most, stepsUntil(clock, std::min({clock.nextCycle, nextExperiment(world), nextLook(world)})),
                      wholeStepsUntilEnd(world)});
  if (steps <= 1) return step(world);
  const BeforeStep before(world);
  if (!moveIsolated(world, steps)) {
    for (; steps > 0; --steps) step(world);  // one of these steps says what is wrong
    return;
  }
  clock.time = timeAfter(clock, steps);
  clock.step += steps;
  runEvents(world, before.clockTime, dueUntil(world, before.clockTime));
  lookForStop(world, before);
}

}  // namespace morula

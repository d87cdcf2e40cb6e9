// One step of a world: the stages of the thesis' figures 4.2 and 4.4. A block of isolated cells, on which no other
// cells act, goes through many time steps while it is in cache.
#include <algorithm>
#include <atomic>

#include "base/error.h"
#include "base/parallel.h"
#include "contacts/contacts.h"
#include "physics/growth.h"
#include "physics/sag.h"
#include "simulation/memory.h"
#include "simulation/settle.h"
#include "simulation/stages.h"

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

void refreshLists(World& world) {
  const Bodies& bodies = *world.bodies;
  world.contacts->list.maxBytes = memoryForLists(world);
  try {
    refreshList(*world.contacts, bodies, world.execution.threads);
  } catch (const ListsTooLong& lists) {
    const auto cell = std::find(bodies.slots.begin(), bodies.slots.end(), lists.block * blockLanes);
    throw NumericalError(
        world.cells.path[cell - bodies.slots.begin()].text(), world.clock.step,
        "lists of the vertices near each vertex would take more than " + bytesText(world.contacts->list.maxBytes) +
            ", which the memory limit of " + bytesText(world.execution.memoryLimit) +
            " leaves them: too many vertices are within reach of each other",
        "move cells apart (cells: at), give a smaller physics.contact.radius or a coarser physics.mesh, or "
        "raise --memory-limit",
        Want::memory);
  }
}

}  // namespace

double timeAfter(const Clock& clock, std::uint64_t steps) {
  return clock.epochTime + static_cast<double>(clock.step + steps - clock.epochStep) * clock.timeStep;
}

void step(World& world) {
  if (settles(world)) return stepQuasiStatic(world);
  Clock& clock = world.clock;
  const double before = clock.time;
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
    clock.time = std::min(clock.nextCycle, std::max(before, nextExperiment(world)));
  }
  runEvents(world, before, dueUntil(world, before));
  followContacts(world);
}

void movePhysics(World& world, double timeStep) {
  if (world.bodies->count == 0) return;
  for (std::size_t i = 0; i <= world.stages.furtherDrifts.size(); ++i) moveAndEvaluate(world, i, timeStep);
}

void evaluateForces(World& world) { movePhysics(world, 0); }

void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep) {
  Bodies& bodies = *world.bodies;
  const int blocks = bodies.blockCount(), threads = world.execution.threads;
  const bool isolated =
      !world.contacts && !world.connections && !world.motility && !world.swirls;  // one pass over a block in cache

  const auto stagesOf = [&](const BlockView& block) {
    const PhysicsStages& stages = world.stagesOfLanes[block.liveLanes - 1];
    return evaluation == 0 ? stages : furtherStages(stages, evaluation - 1);
  };

  const double sinceLast = timeStep / static_cast<double>(world.stages.furtherDrifts.size() + 1);
  parallelFor(blocks, threads, [&](int i) {
    const BlockView block = bodies.block(i, threadNumber());
    const PhysicsStages stages = stagesOf(block);
    advance(stages, bodies, block, timeStep);
    if (world.contacts) takeSnapshot(*world.contacts, bodies, block, i, sinceLast);
    if (isolated) kick(stages, bodies, block, timeStep);
  });
  if (isolated) return;

  if (world.swirls) addSwirlForces(world);
  if (world.connections) addConnectionForces(*world.connections, world.cells.path, bodies, threads);
  if (world.motility) addMotility(world);
  if (world.contacts) {
    checkReach(world);
    refreshLists(world);
  }
  parallelFor(blocks, threads, [&](int i) {
    if (world.contacts) addContactForces(*world.contacts, bodies, i, world.clock.timeStep);
    const BlockView block = bodies.block(i, threadNumber());
    kick(stagesOf(block), bodies, block, timeStep);
  });
}

void growCells(World& world, double timeStep) {
  const auto& growth = world.bodies->parameters.growth;
  if (!growth) return;
  bool grows = false;
  for (std::size_t i = 0; i < world.cells.growth.size(); ++i) {
    const double rate = growth->rate * world.cells.growth[i];
    const int slot = world.bodies->slots[i];
    if (rate > 0 && growth->until) growUntil(*world.bodies, slot, rate, timeStep, *growth->until);
    else if (rate != 0) grow(*world.bodies, slot, rate, timeStep);
    grows |= rate != 0;
  }
  if (grows) setSags(*world.bodies);
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

void takeSteps(World& world, std::uint64_t most) {
  Clock& clock = world.clock;
  std::uint64_t steps = 1;
  if (areIsolated(world))
    steps = std::min({most, stepsUntil(clock, std::min(clock.nextCycle, nextExperiment(world))),
                      wholeStepsUntilEnd(world)});
  if (steps <= 1) return step(world);
  const double before = clock.time;
  if (!moveIsolated(world, steps)) {
    for (; steps > 0; --steps) step(world);  // one of these steps says what is wrong
    return;
  }
  clock.time = timeAfter(clock, steps);
  clock.step += steps;
  runEvents(world, before, dueUntil(world, before));
}

}  // namespace morula

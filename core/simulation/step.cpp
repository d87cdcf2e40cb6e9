// The step, as the thesis' figures 4.2 and 4.4 draw it.
#include "base/parallel.h"
#include "physics/growth.h"
#include "simulation/stages.h"

namespace morula {

double timeAfter(const Clock& clock, std::uint64_t steps) {
  return clock.epochTime + static_cast<double>(clock.step + steps - clock.epochStep) * clock.timeStep;
}

void step(World& world) {
  Clock& clock = world.clock;
  ++clock.step;
  if (world.bodies) {
    clock.time = timeAfter(clock, 0);
    growCells(world, clock.timeStep);
    movePhysics(world, clock.timeStep);
    checkBodies(world);
    releaseConnections(world);
  } else {
    clock.time = clock.nextCycle;
  }
  if (clock.time >= clock.nextCycle) runCellCycles(world);
}

void movePhysics(World& world, double timeStep) {
  if (world.bodies->count == 0) return;
  for (std::size_t i = 0; i <= world.stages.furtherDrifts.size(); ++i) moveAndEvaluate(world, i, timeStep);
}

void moveAndEvaluate(World& world, std::size_t evaluation, double timeStep) {
  Bodies& bodies = *world.bodies;
  const int blocks = bodies.blockCount(), threads = world.execution.threads;
  const bool alone =
      !world.contacts && !world.connections;  // no cell needs another: one pass while a block is hot

  const auto stagesOf = [&](const BlockView& block) {
    const PhysicsStages& stages = world.stagesOfLanes[block.liveLanes - 1];
    return evaluation == 0 ? stages : furtherStages(stages, evaluation - 1);
  };

  parallelFor(blocks, threads, [&](int i) {
    const BlockView block = bodies.block(i, threadNumber());
    const PhysicsStages stages = stagesOf(block);
    advance(stages, bodies, block, timeStep);
    if (world.contacts) takeSnapshot(*world.contacts, bodies, block, i);
    if (alone) kick(stages, bodies, block, timeStep);
  });
  if (alone) return;

  if (world.connections) addConnectionForces(*world.connections, world.cells.path, bodies);
  if (world.contacts) {
    checkReach(world);
    refreshList(*world.contacts, bodies, threads);
  }
  parallelFor(blocks, threads, [&](int i) {
    if (world.contacts) addContactForces(*world.contacts, bodies, i, world.clock.timeStep);
    const BlockView block = bodies.block(i, threadNumber());
    kick(stagesOf(block), bodies, block, timeStep);
  });
}

void growCells(World& world, double timeStep) {
  const auto& growth = world.model.mechanics->physics.growth;
  if (!growth) return;
  for (std::size_t i = 0; i < world.cells.growth.size(); ++i)
    if (world.cells.growth[i] != 0)
      grow(*world.bodies, world.bodies->slots[i], growth->rate * world.cells.growth[i], timeStep);
}

}  // namespace morula

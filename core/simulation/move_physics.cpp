// The physical stages of a step: growth, motion, and every force at the new positions.

#include "simulation/move_physics.h"

#include <algorithm>

#include "base/error.h"
#include "base/parallel.h"
#include "contacts/contacts.h"
#include "physics/growth.h"
#include "physics/sag.h"
#include "simulation/check_bodies.h"
#include "simulation/memory.h"
#include "simulation/motility.h"
#include "simulation/swirls.h"

namespace morula {
namespace {

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

}  // namespace morula


#include "simulation/restore.h"

#include <algorithm>

#include "contacts/contacts.h"
#include "simulation/adhesion_kinds.h"
#include "simulation/experiments.h"
#include "simulation/swirls.h"
#include "state/checkpoint_state.h"

namespace morula {
namespace {

/// Takes the snapshots that the last step saw, for measures of contacts before the next step. Overwrites forces.
void takeSnapshots(World& world) {
  Bodies& b = *world.bodies;
  for (int i = 0; i < b.blockCount(); ++i) {
    const BlockView block = b.block(i, 0);
    const std::size_t first = std::size_t(b.blocks[i].firstLine) * vertexStride;
    for (int k = 0; k < b.verticesPerLane(i) * vertexStride; ++k) b.scratch[0].predicted[k] = b.velocity[first + k];
    const TemplateView mesh = b.meshAt(block.meshLevel).view();
    world.stages.findTensions(mesh, block, b.kernelParameters);
    world.stages.accumulateRings(mesh, block, b.kernelParameters);
    takeSnapshot(*world.contacts, b, block, i);
  }
}

void restoreContacts(const SavedContacts& s, World& world) {
  Contacts& c = *world.contacts;
  Bodies& b = *world.bodies;
  resetContacts(c, b);
  sortByAdhesion(world);
  if (b.count > 0) {
    setInfluenceRadii(c, b, s.listIsValid ? s.radius : s.snapshotRadius);
    const Reals acceleration = b.acceleration;
    const AlignedVector<double> volume = b.volume;
    writeVectors(s.reference, b, c.list.reference);
    buildNeighbourList(c.list, b, c.radius, world.execution.threads);
    takeSnapshots(world);
    b.acceleration = acceleration;
    b.volume = volume;
    if (choosesPairs(c)) choosePairs(c, b, world.execution.threads);  // for what the next step measures before it moves
    setInfluenceRadii(c, b, s.radius);
    if (c.parameters.adhesion) findPairStrengths(c, b, world.execution.threads);
    findCrowding(c, b, world.execution.threads);
  }
  c.listIsValid = s.listIsValid && b.count > 0;
  auto counter = s.counters.begin();
  for (std::uint64_t* own : countersOf(c)) *own = *counter++;
}

/// Restores the list of connections that hold, sorted by pair.
void restoreActive(Connections& connections) {
  const auto& history = connections.history;
  connections.active.clear();
  for (std::size_t i = 0; i < history.size(); ++i)
    if (history[i].released < 0) connections.active.push_back(i);
  std::sort(connections.active.begin(), connections.active.end(), [&](std::size_t i, std::size_t j) {
    return std::pair{history[i].a, history[i].b} < std::pair{history[j].a, history[j].b};
  });
}

}  // namespace

void restoreState(World& world, std::string_view checkpoint) { takeState(world, readCheckpoint(checkpoint, world)); }

void takeState(World& world, SavedState s) {
  world.clock = s.world.clock;
  world.stoppedBy.reset();  // runs go on from states before their stop
  world.cells = std::move(s.world.cells);
  world.lineage = std::move(s.world.lineage);
  world.timeSteps = std::move(s.world.timeSteps);
  world.divisions = std::move(s.world.divisions);
  if (world.experiments) world.experiments = std::move(s.world.experiments).value_or(std::vector<ExperimentRecord>());
  restoreExperiments(world);
  world.polarities = std::move(s.world.polarities);
  if (world.birthSizes) world.birthSizes = std::move(s.world.birthSizes);
  if (world.settlings) world.settlings = std::move(s.world.settlings);
  if (world.bodies) world.bodies = std::move(s.world.bodies);
  restoreExperiments(world);
  if (world.contacts) restoreContacts(s.contacts, world);
  if (world.motility) world.motility->isCurrent = false;
  if (world.connections) {
    world.connections->history = std::move(s.world.connections->history);
    restoreActive(*world.connections);
  }
  findSwirls(world);
}

}  // namespace morula

#include "golden/observe.h"

#include "contacts/contacts.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

namespace morula {

GoldenData observeGolden(const World& world, GoldenFacts facts) {
  facts.seed = world.model.seed;
  facts.steps = world.clock.step;
  facts.lineage = world.lineage.entries;
  facts.describe = [&](StateId state) { return world.biology->describe(state); };
  for (const TimeStepChange& t : world.timeSteps) facts.timeSteps.push_back({t.step, t.time, t.timeStep});
  facts.stateHash = stateHash(world);
  if (world.contacts)
    facts.costs = {{"pair_evaluations", world.contacts->pairEvaluations}, {"list_builds", world.contacts->rebuilds}};
  facts.mechanics = world.bodies.has_value();
  if (facts.mechanics) {
    facts.end = measureWorld(world);
    if (world.cells.path.size() <= goldenCellLimit) facts.cells = measureCells(world);
  }
  return makeGoldenData(facts);
}

}  // namespace morula

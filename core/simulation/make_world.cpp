#include "simulation/make_world.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "biology/logical_dna.h"
#include "biology/substances.h"
#include "contacts/contacts.h"
#include "observation/observation.h"
#include "physics/growth.h"
#include "physics/integrator.h"
#include "simulation/adhesion_kinds.h"
#include "simulation/check_bodies.h"
#include "simulation/cycle_lengths.h"
#include "simulation/memory.h"
#include "simulation/move_physics.h"
#include "simulation/settle.h"
#include "simulation/simulation.h"
#include "simulation/start_cells.h"
#include "simulation/start_variation.h"
#include "simulation/stop_when.h"
#include "simulation/swirls.h"
#include "simulation/time_step.h"
#include "state/check_numbers.h"

namespace morula {

namespace {

/// Sets parameters to 0 that act on moving cells only, and so do not change where cells come to rest.
void leaveOutMotion(MechanicsScene& m) {
  m.physics.drag = 0;
  m.physics.membrane.damping = 0;
  if (m.contact) m.contact->damping = 0, m.contact->viscosity = 0;
}

/// Returns the search for the scene's contacts. Vertices that settle go farther from one evaluation to the next than in
/// a time step, so that longer lists pay: with twice the skin elegans-128 takes a tenth less time.
SearchSettings searchOf(const MechanicsScene& m, SearchSettings search) {
  if (m.physics.integrator == Integrator::quasiStatic) search.skinShare *= 2;
  return search;
}

}  // namespace

World makeWorld(const Scene& scene, const Execution& execution) {
  return makeWorld(scene, makeLogicalDna(scene.dna, scene.cycle, scene.senses), execution);
}

World makeWorld(const Scene& scene, std::unique_ptr<BiologicalUnit> biology, const Execution& execution) {
  World world;
  world.model = scene;
  if (scene.mechanics && kindOf(scene.mechanics->physics.integrator).settles) leaveOutMotion(*world.model.mechanics);
  world.execution = execution;
  world.biology = std::move(biology);
  if (!scene.experiments.empty()) world.experiments.emplace();
  refuseEndlessPace(scene);
  createFounders(world);
  if (!scene.mechanics) {
    lookForStop(world);
    return world;
  }

  const MechanicsScene& m = *world.model.mechanics;
  world.divisionPolicy = makeDivisionPolicy(m.division, scene.seed, scene.variation);
  world.bodies = makeBodies(m.physics, m.mesh, execution.threads, m.coarser);
  if (m.contact)
    world.contacts = makeContacts(*m.contact, execution.isa, searchOf(m, execution.search), m.physics.precision,
                                  m.physics.cell.model);
  if (m.connections) world.connections = Connections{*m.connections, {}, {}, {}};
  if (keepsPolarity(m.division)) world.polarities.emplace();
  if (m.physics.motility) world.motility.emplace();
  if (settles(world)) world.settlings.emplace();
  setStages(world, execution.isa);
  requireMemoryForStart(world);
  setBodies(*world.bodies, makeStartBodies(*world.bodies, placeStart(scene, world.cells.path)));
  if (scene.cycle.divisionSize && scene.cycle.divisionSize->rule == DivisionSize::Rule::adder) {
    world.birthSizes.emplace();
    for (int slot : world.bodies->slots) world.birthSizes->push_back({sizeAtRest(*world.bodies, slot)});
  }
  if (scene.cycle.divisionSize)  // an egg may have to grow before its first cycle
    for (std::size_t i = 0; i < world.cells.path.size(); ++i)
      world.cells.growth[i] = world.biology->wantsToGrow(ObservedCell(Observation(world), static_cast<int>(i)));
  try {
    beginWithBodies(world);
    checkNumbers(world);
    checkStart(world);
  } catch (const NumericalError& e) {
    const std::string who = e.cell.empty() ? "" : "cell " + e.cell + ": ";
    throw InputError(who + e.quantity + "; " + e.remedy, {}, e.key);  // no step has been made: the scene is invalid
  }
  lookForStop(world);
  return world;
}

void setStages(World& world, Isa isa) {
  const PhysicsParameters& p = world.bodies->parameters;
  const bool surfaces = world.contacts.has_value();
  world.stages = chooseStages(p, isa, surfaces);
  for (int cells = 1; cells <= blockLanes; ++cells)
    world.stagesOfLanes[cells - 1] = chooseStages(p, narrowestIsa(cells, isa, p.precision), surfaces);
}

void beginWithBodies(World& world) {
  findSwirls(world);
  if (world.contacts) resetContacts(*world.contacts, *world.bodies);
  sortByAdhesion(world);
  if (world.motility) world.motility->isCurrent = false;
  if (world.clock.timeStep == 0 && !settles(world))
    world.clock.timeStep = world.bodies->parameters.timeStep.value_or(1);
  evaluateForces(world);
  checkBodies(world);
  chooseTimeStep(world);
}

}  // namespace morula

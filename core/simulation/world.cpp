#include "simulation/world.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "biology/logical_dna.h"
#include "biology/substances.h"
#include "contacts/contacts.h"
#include "physics/growth.h"
#include "physics/integrator.h"
#include "simulation/memory.h"
#include "simulation/population.h"
#include "simulation/settle.h"
#include "simulation/stages.h"
#include "simulation/start_variation.h"

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

/// Sets parameters to 0 that act on moving cells only, and so do not change where cells come to rest.
void leaveOutMotion(MechanicsScene& m) {
  m.physics.drag = m.physics.membrane.damping = 0;
  if (m.contact) m.contact->damping = m.contact->friction = 0;
}

}  // namespace

int cellNumber(const Cells& cells, const CellPath& path) {
  const auto at = std::ranges::lower_bound(cells.path, path);
  return at != cells.path.end() && *at == path ? static_cast<int>(at - cells.path.begin()) : -1;
}

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
  if (!scene.mechanics) return world;

  const MechanicsScene& m = *world.model.mechanics;
  world.divisionPolicy = makeDivisionPolicy(m.division, scene.seed, scene.variation);
  world.bodies = makeBodies(m.physics, m.mesh, execution.threads, m.coarser);
  if (m.contact)
    world.contacts =
        makeContacts(*m.contact, execution.isa, execution.search, m.physics.precision, m.physics.cell.model);
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
    throw InputError(who + e.quantity + "; " + e.remedy);  // no step has been made: the scene is invalid
  }
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

std::optional<double> plannedEnd(const Scene& scene) {
  std::optional<double> end = scene.stop.time;
  if (scene.stop.cycles) {
    const double cycles = static_cast<double>(*scene.stop.cycles) * scene.cycle.length;
    end = end ? std::min(*end, cycles) : cycles;
  }
  return end;
}

bool usesSeed(const Scene& scene) {
  const VariationParameters& v = scene.variation;
  if (v.cycle > 0 || (scene.mechanics && v.start > 0)) return true;
  const auto divides = [&](const Gene& gene) { return scene.dna.substances[gene.product] == substance::divide; };
  if (scene.mechanics && (scene.mechanics->physics.motility || v.adhesion > 0)) return true;
  if (!scene.mechanics || std::ranges::none_of(scene.dna.genes, divides)) return false;
  const DivisionParameters& division = scene.mechanics->division;
  return v.share > 0 || v.tilt > 0 || kindOf(division.otherwise.plane).usesSeed ||
         std::ranges::any_of(division.rules, [](const DivisionRule& rule) {
           return rule.tilt.value_or(0) > 0 || (rule.plane && kindOf(rule.plane->plane).usesSeed);
         });
}

bool finished(const World& world) {
  if (world.cells.path.empty() || hasEnoughCells(world)) return true;
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

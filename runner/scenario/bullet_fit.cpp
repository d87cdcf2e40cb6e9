#include "scenario/bullet_fit.h"

#include "base/maths.h"
#include "biology/substances.h"
#include "simulation/world.h"
#include "yaml/numbers.h"

namespace morula::scenario {

namespace {

/// Whether a gene can make a cell do something that Bullet's bodies do not.
bool acts(const std::string& substance, const MechanicsScene& mechanics) {
  if (substance == substance::divide || substance == substance::die) return true;
  return mechanics.physics.growth && (substance == substance::grow || substance == substance::shrink);
}

void checkGenes(const Scenario& scenario, std::vector<Unfit>& unfit) {
  for (const Gene& gene : scenario.scene.dna.genes) {
    const std::string& product = scenario.scene.dna.substances[gene.product];
    if (acts(product, *scenario.scene.mechanics))
      unfit.push_back({true, "gene " + gene.name + " makes cells " + product + ", which Bullet's do not",
                       "remove the gene, or this"});
  }
}

/// Bullet takes its time step as a float.
void checkTimeStep(const PhysicsParameters& physics, std::vector<Unfit>& unfit) {
  if (!physics.timeStep || static_cast<float>(*physics.timeStep) == *physics.timeStep) return;
  unfit.push_back({false,
                   "physics.time_step " + exactText(*physics.timeStep) +
                       " is no single-precision number, as Bullet needs it",
                   "use auto, or a power of two as " + exactText(powerOfTwoBelow(*physics.timeStep))});
}

}  // namespace

std::vector<Unfit> unfitForBullet(const Scenario& scenario, Baseline baseline) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  std::vector<Unfit> unfit;
  checkGenes(scenario, unfit);
  if (!kindOf(mechanics.physics.cell.model).hasMembrane)
    unfit.push_back({true, "Bullet's cells are membranes around contents",
                     "use physics.cell.model: shell, or remove this"});
  if (mechanics.connections)
    unfit.push_back({true, "Bullet's cells cannot be connected", "remove connections, or this"});
  if (mechanics.contact && mechanics.contact->friction > 0)
    unfit.push_back({true, "Bullet has no Coulomb friction between soft bodies",
                     "set physics.contact.friction to 0, or remove this"});
  if (!plannedEnd(scenario.scene))
    unfit.push_back({false, "the run's end is not known beforehand", "give stop.time"});
  if (!scenario.check.fails.empty())
    unfit.push_back({false, "a run that must stop has no end to compare", "remove check.fails, or this"});
  if (mechanics.physics.precision == Precision::binary32)
    unfit.push_back({false, "Bullet computes in double precision", "set physics.precision to double"});
  checkTimeStep(mechanics.physics, unfit);
  if (baseline == Baseline::b3 && mechanics.contact)
    unfit.push_back({false, "b3 does not compute contact", "use b1, or remove physics.contact"});
  if (baseline == Baseline::b3 && mechanics.physics.shell)
    unfit.push_back({false, "b3 does not compute a shell", "use b1, or remove physics.shell"});
  return unfit;
}

}  // namespace morula::scenario

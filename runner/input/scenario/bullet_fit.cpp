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

void checkGenes(const Scenario& scenario, std::vector<Incompatibility>& found) {
  for (const Gene& gene : scenario.scene.dna.genes) {
    const std::string& product = scenario.scene.dna.substances[gene.product];
    if (acts(product, *scenario.scene.mechanics))
      found.push_back({true, "gene " + gene.name + " makes cells " + product + ", which Bullet's do not",
                       "remove the gene, or this"});
  }
}

/// Bullet takes its time step as a float.
void checkTimeStep(const PhysicsParameters& physics, std::vector<Incompatibility>& found) {
  if (!physics.timeStep || static_cast<float>(*physics.timeStep) == *physics.timeStep) return;
  found.push_back(
      {false,
       "physics.time_step " + exactText(*physics.timeStep) + " is no single-precision number, as Bullet needs it",
       "use auto, or a power of two as " + exactText(powerOfTwoBelow(*physics.timeStep))});
}

}  // namespace

std::vector<Incompatibility> bulletIncompatibilities(const Scenario& scenario, Baseline baseline) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  std::vector<Incompatibility> found;
  checkGenes(scenario, found);
  if (!kindOf(mechanics.physics.cell.model).hasMembrane)
    found.push_back(
        {true, "Bullet's cells are membranes around contents", "use physics.cell.model: shell, or remove this"});
  if (baseline == Baseline::b3 && mechanics.physics.membrane.springs != Springs::equal)
    found.push_back({false, "b3's springs are all as stiff", "set physics.membrane.springs to equal, or use b1"});
  if (mechanics.connections)
    found.push_back({true, "Bullet's cells cannot be connected", "remove connections, or this"});
  if (mechanics.contact && mechanics.contact->friction > 0)
    found.push_back({true, "Bullet has no Coulomb friction between soft bodies",
                     "set physics.contact.friction to 0, or remove this"});
  if (mechanics.contact && mechanics.contact->adhesion)
    found.push_back(
        {true, "Bullet's soft bodies do not stick to each other", "remove physics.contact.adhesion, or this"});
  if (mechanics.physics.motility)
    found.push_back({true, "Bullet's cells do not crawl", "remove physics.motility, or this"});
  if (!plannedEnd(scenario.scene)) found.push_back({false, "the run's end is not known beforehand", "give stop.time"});
  if (!scenario.check.fails.empty())
    found.push_back({false, "a run that must stop has no end to compare", "remove check.fails, or this"});
  if (mechanics.physics.precision == Precision::binary32)
    found.push_back({false, "Bullet computes in double precision", "set physics.precision to double"});
  checkTimeStep(mechanics.physics, found);
  if (baseline == Baseline::b3 && mechanics.contact)
    found.push_back({false, "b3 does not compute contact", "use b1, or remove physics.contact"});
  if (baseline == Baseline::b3 && mechanics.physics.shell)
    found.push_back({false, "b3 does not compute a shell", "use b1, or remove physics.shell"});
  if (mechanics.physics.shell && mechanics.physics.shell->mesh)
    found.push_back({false, "Bullet is not given a shell that is a mesh", "use an ellipsoid, or remove this"});
  return found;
}

}  // namespace morula::scenario

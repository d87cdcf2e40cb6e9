#include "scenario/bullet_fit.h"

#include "base/maths.h"
#include "biology/substances.h"
#include "simulation/simulation.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

/// Returns true if a gene can make a cell do something that Bullet's bodies do not.
bool acts(const std::string& substance, const MechanicsScene& mechanics) {
  if (substance == substance::divide || substance == substance::die) return true;
  return mechanics.physics.growth && (substance == substance::grow || substance == substance::shrink);
}

}  // namespace

std::vector<Incompatibility> bulletIncompatibilities(const Scenario& scenario, Baseline baseline) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  const PhysicsParameters& physics = mechanics.physics;
  const auto& contact = mechanics.contact;
  const bool isB3 = baseline == Baseline::b3;
  std::vector<Incompatibility> found;
  for (const Gene& gene : scenario.scene.dna.genes)
    if (const std::string& product = scenario.scene.dna.substances[gene.product]; acts(product, mechanics))
      found.push_back({true, "gene " + gene.name + " makes cells " + product + ", and Bullet's cells do not",
                       "remove the gene, or check.bullet"});
  const auto lacks = [&](bool is, const char* wrong, const char* right) {
    if (is) found.push_back({true, wrong, right});
  };
  const auto differs = [&](bool is, const std::string& wrong, const std::string& right) {
    if (is) found.push_back({false, wrong, right});
  };
  lacks(!kindOf(physics.cell.model).hasMembrane, "Bullet's cells are membranes around contents",
        "use physics.cell.model: shell, or remove check.bullet");
  differs(isB3 && physics.membrane.springs != Springs::equal, "b3's springs are all equally stiff",
          "set physics.membrane.springs to equal, or use b1");
  lacks(physics.membrane.bending > 0, "Bullet's membranes do not bend by our law",
        "remove physics.membrane.bending, or check.bullet");
  lacks(mechanics.connections.has_value(), "Bullet's cells cannot be connected", "remove connections, or check.bullet");
  lacks(contact && contact->viscosity > 0, "Bullet has no contact viscosity between soft bodies",
        "set physics.contact.viscosity to 0, or remove check.bullet");
  lacks(contact && contact->adhesion, "Bullet's soft bodies do not stick to each other",
        "remove physics.contact.adhesion, or check.bullet");
  lacks(physics.motility.has_value(), "Bullet's cells do not crawl", "remove physics.motility, or check.bullet");
  differs(!plannedEnd(scenario.scene), "the time of the run's end is not known beforehand", "give stop.time");
  differs(!scenario.check.fails.empty(), "a run that must stop has no end to compare",
          "remove check.fails, or check.bullet");
  differs(physics.precision == Precision::binary32, "Bullet computes in double precision",
          "set physics.precision to double");
  if (const auto& dt = physics.timeStep)  // Bullet takes the time step as a float
    differs(static_cast<float>(*dt) != *dt,
            "physics.time_step " + exactText(*dt) + " is not exact in single precision, which Bullet needs",
            "use auto, or a power of two as " + exactText(powerOfTwoBelow(*dt)));
  differs(isB3 && contact, "b3 does not compute contact", "use b1, or remove physics.contact");
  differs(isB3 && physics.shell, "b3 does not compute a shell", "use b1, or remove physics.shell");
  differs(physics.shell && physics.shell->mesh, "Bullet cannot take a shell that is a mesh",
          "use an ellipsoid, or remove check.bullet");
  return found;
}

}  // namespace morula::scenario

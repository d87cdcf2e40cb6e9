#include "base/vec3.h"
#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "scenario/scene_checks.h"

namespace morula::scenario {

void checkSettling(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  const auto refuse = [&](const std::string& path, const std::string& wrong, const std::string& right) {
    reading.problems.add(placeOf(root, path), path, wrong, right);
  };
  if (!kindOf(m.physics.integrator).settles) {
    if (given(root, "physics.settle"))
      refuse("physics.settle",
             "is for physics.integrator fire, and here it is " + std::string(nameOf(m.physics.integrator)),
             "remove this, or give integrator: fire");
    return;
  }
  const std::string other = "remove this, or give another physics.integrator, such as velocity-verlet";
  const auto cannot = [&](const char* path, const std::string& why) { refuse(path, "integrator fire " + why, other); };
  if (m.physics.timeStep) cannot("physics.time_step", "has no time step: it goes from one equilibrium to the next");
  if (m.physics.motility) cannot("physics.motility", "knows no time in which cells could crawl");
  if (m.division.chirality) cannot("division.chirality", "knows no time in which daughters could turn");
  for (const DivisionRule& rule : m.division.rules)
    if (rule.chirality) cannot("division.rules", "knows no time in which daughters could turn (chirality)");
  if (m.contact && m.contact->law == ContactLaw::thesis)
    cannot("physics.contact.law", "needs contacts with an energy, which the thesis' law has not");
  if (kindOf(m.physics.cell.model).hasRestShape)
    cannot("physics.cell.model", "needs cells with an energy, and goals of shape matching move with them");
  for (const StartCell& cell : scenario.scene.cells)
    if (norm(cell.velocity) > 0) cannot("cells", "knows no motion, and here is a velocity");
  if (scenario.check.energy) cannot("check.energy", "lets energy go");
  if (scenario.check.bullet) cannot("check.bullet", "has no time in which Bullet could be compared with it");
}

}  // namespace morula::scenario

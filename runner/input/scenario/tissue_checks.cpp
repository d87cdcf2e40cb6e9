// Checks of adhesion, connections, motility and settling.
#include <algorithm>

#include "base/number_text.h"
#include "base/vec3.h"
#include "biology/substances.h"
#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "scenario/scene_checks.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

/// Checks that cells that connect by touch have contact, and that a gene produces 'connect' if genes decide.
void checkConnecting(const SceneCheck& check) {
  const Dna& dna = check.scene().dna;
  const MakeConnections make = check.mechanics().connections->make;
  const bool byGene = make == MakeConnections::byGene || make == MakeConnections::both;
  if (make == MakeConnections::atDivision) return;
  if (!check.mechanics().contact)
    check.refuse("connections.make",
                 std::string(byGene ? "genes connect only cells" : "this makes connections only of cells") +
                     " that touch, and cells do not touch without physics.contact",
                 "add 'contact: {}' to physics, or set this to at-division");
  if (!byGene) return;
  const auto connect = findSubstance(dna, substance::connect);
  const bool wanted = connect && (std::ranges::find(dna.start, *connect) != dna.start.end() ||
                                  std::ranges::find(dna.genes, *connect, &Gene::product) != dna.genes.end() ||
                                  std::ranges::any_of(check.reading.substances, [](const SubstanceUse& use) {
                                    return use.path.starts_with("cells") && use.name == substance::connect;
                                  }));
  if (!wanted && !dna.substances.empty())  // empty: an unreadable DNA, which has been reported
    check.refuse("connections.make", "no gene produces 'connect', so genes never connect cells",
                 "write a gene such as g9(connect|a0), or set this to at-division");
}

// [1] Max adhesion over the contact stiffness, and over the membranes'. Heaps of 27 meshes and of 64 spheres bore it.
// With 0.13 of the first, spheres slipped into each other; with 0.25 of the second, touching meshes folded.
constexpr double overContact = 0.1, overMembrane = 0.2;

}  // namespace

void checkConnections(const SceneCheck& check) {
  if (!check.mechanics().connections) return;
  checkConnecting(check);
  const ConnectionParameters& c = *check.mechanics().connections;
  if (c.spring && c.strength)
    check.refuse("connections.strength", "stands beside spring, but a connection has a strength or is a spring",
                 "give one of strength or spring");
  if (c.releaseTension && !c.spring)
    check.refuse("connections.release-tension",
                 "is the tension of a spring, but here every connection pulls with one strength",
                 "add 'spring: {}' to connections, or use release-distance");
}

void checkAdhesion(const SceneCheck& check) {
  const auto& contact = check.mechanics().contact;
  if (!contact || !contact->adhesion) return;
  const std::string path = "physics.contact.adhesion";
  if (contact->law == ContactLaw::thesis)
    check.refuse(path, "is for physics.contact.law pair", "remove this, or give law: pair");
  double largest = contact->adhesion->strength;
  for (const AdhesionPair& pair : contact->adhesion->pairs) largest = std::max(largest, pair.strength);
  const auto bound = [&](double stiffness, double share, const std::string& whose, const char* what) {
    if (largest <= stiffness * share) return;
    check.refuse(path, exactText(largest) + what + exactText(stiffness),
                 "needs at most " + numberText(stiffness * share) + ", or a " + whose + " of at least " +
                     numberText(largest / share));
  };
  const PhysicsParameters& physics = check.physics();
  bound(contact->stiffness, overContact, "physics.contact.stiffness",
        " would draw cells into each other against a contact stiffness of ");
  if (kindOf(physics.cell.model).hasMembrane)
    bound(physics.membrane.stiffness, overMembrane, "physics.membrane.stiffness",
          " would fold cells where they touch, with membranes of stiffness ");
}

void checkMotility(const SceneCheck& check) {
  if (check.physics().motility && check.physics().drag == 0)
    check.refuse("physics.motility", "cells crawl against the drag of their medium, and the drag is 0",
                 "give a physics.drag > 0, or remove this");
}

void checkSettling(const SceneCheck& check) {
  const MechanicsScene& m = check.mechanics();
  const std::string own = nameOf(m.physics.integrator);
  if (!kindOf(m.physics.integrator).settles) {
    if (given(check.root, "physics.quasi-static"))
      check.refuse("physics.quasi-static", "is for physics.integrator quasi-static, and here it is " + own,
                   "remove this, or give integrator: quasi-static");
    return;
  }
  const auto cannot = [&](const char* path, const std::string& why) {
    check.refuse(path, "integrator " + own + " " + why,
                 "remove this, or give another physics.integrator, such as velocity-verlet");
  };
  if (m.physics.timeStep)
    cannot("physics.time_step",
           "has no time step, because it goes from one equilibrium to "
           "the next");
  if (m.physics.motility) cannot("physics.motility", "knows no time in which cells could crawl");
  if (m.division.chirality) cannot("division.chirality", "knows no time in which daughters could turn");
  for (const DivisionRule& rule : m.division.rules)
    if (rule.chirality) cannot("division.rules", "knows no time in which daughters could turn (chirality)");
  if (m.contact && m.contact->law == ContactLaw::thesis)
    cannot("physics.contact.law", "needs contacts with an energy, and the thesis' law has none");
  if (kindOf(m.physics.cell.model).hasRestShape)
    cannot("physics.cell.model",
           "needs cells with an energy, and shape matching has none: its goals move with the "
           "cells");
  for (const StartCell& cell : check.scene().cells)
    if (norm(cell.velocity) > 0) cannot("cells", "knows no motion, and a cell has a velocity");
  if (check.scenario.check.energy) cannot("check.energy", "does not conserve energy");
  if (check.scenario.check.bullet) cannot("check.bullet", "has no time at which Bullet could be compared with it");
}

}  // namespace morula::scenario

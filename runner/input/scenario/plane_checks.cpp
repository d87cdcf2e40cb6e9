// Division planes go by what a scene may lack: contacts, connections, a long shell. So does chirality, by drag.
#include "physics/cell_model.h"
#include "scenario/scene_checks.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

/// What is wrong, and what would be right.
using Refuse = std::function<void(const std::string& wrong, const std::string& right)>;

void checkPlane(const PlaneChoice& choice, const MechanicsScene& m, const Refuse& refuse) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  const std::string name = kind.name;
  const bool turns = kind.takes == Takes::polarity && !choice.substance.empty();
  if ((kind.needsContact || turns) && !m.contact)
    refuse(
        name + (turns ? " turns to contacts" : " goes by contacts") + ", and without physics.contact cells have none",
        "add 'contact: {}' to physics, or choose another plane");
  if (kind.needsConnections && !m.connections)
    refuse(name + " goes by connections, and without a section connections cells have none",
           "add 'connections: {}', or choose another plane");
  if (!kind.needsLongShell) return;
  const std::string right = "give physics: {shell: {ellipsoid: [3, 2, 2]}}, or choose another plane";
  if (!m.physics.shell) return refuse(name + " needs a shell", right);
  if (m.physics.shell->mesh) return refuse("a shell that is a mesh has no semi-axes", right);
  const auto& [a, b, c] = m.physics.shell->semiAxes;
  if (a == b && b == c) refuse("a sphere has no longest axis", right);
}

/// Where the value could not be read, that has been said.
bool hasNoDrag(const MechanicsScene& m, const Node& root) {
  if (m.physics.drag > 0) return false;
  const Member* physics = root.find("physics");
  const Member* drag = physics ? physics->value.find("drag") : nullptr;
  Problems said("");
  return !drag || readReal(drag->value, notNegative, "", "", said);
}

void checkChirality(const Chirality& chirality, bool mayBeNone, const MechanicsScene& m, const Node& root,
                    const Refuse& refuse) {
  if (chirality.angle == 0 && !mayBeNone) return refuse("an angle of 0 turns nothing", "remove it, or give an angle");
  if (!kindOf(m.physics.cell.model).hasMesh) refuse("a sphere looks the same when it has turned", "remove this");
  if (hasNoDrag(m, root))
    refuse("the medium turns daughters by its drag, and physics.drag is 0", "needs physics.drag > 0");
}

}  // namespace

void checkPlanes(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  const DivisionParameters& division = m.division;
  const auto at = [&](const Place& place, const std::string& path) {
    return [&reading, place, path](const std::string& wrong, const std::string& right) {
      reading.problems.add(place, path, wrong, right);
    };
  };
  const auto ofAll = [&](const std::string& path) { return at(placeOf(root, path), path); };
  checkPlane(division.otherwise, m, ofAll("division.plane"));
  if (division.chirality) checkChirality(*division.chirality, false, m, root, ofAll("division.chirality"));
  if (reading.rules.size() != division.rules.size()) return;  // some could not be read, which has been said
  for (std::size_t i = 0; i < division.rules.size(); ++i) {
    const DivisionRule& rule = division.rules[i];
    const std::string path = "division.rules[" + std::to_string(i) + "]";
    if (rule.plane) checkPlane(*rule.plane, m, at(reading.rules[i], path + ".plane"));
    if (rule.chirality)
      checkChirality(*rule.chirality, division.chirality.has_value(), m, root,
                     at(reading.rules[i], path + ".chirality"));
  }
}

}  // namespace morula::scenario

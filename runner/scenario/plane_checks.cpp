// Division planes go by what a scene may lack: contacts, connections, a long shell. So does chirality, by drag.
#include "physics/cell_model.h"
#include "scenario/value_types.h"

namespace morula::scenario {

namespace {

const Node* inside(const Node* node, std::string_view key) {
  const Member* member = node ? node->find(key) : nullptr;
  return member ? &member->value : nullptr;
}

/// What is wrong, and what would be right.
using Refuse = std::function<void(const std::string& wrong, const std::string& right)>;

void checkPlane(const PlaneChoice& choice, const MechanicsScene& m, const Refuse& refuse) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  const std::string name = kind.name;
  const bool turns = kind.takes == Takes::polarity && !choice.substance.empty();
  if ((kind.needsContact || turns) && !m.contact)
    refuse(name + (turns ? " turns to contacts" : " goes by contacts") +
               ", and without physics.contact cells have none",
           "add 'contact: {}' to physics, or choose another plane");
  if (kind.needsConnections && !m.connections)
    refuse(name + " goes by connections, and without a section connections cells have none",
           "add 'connections: {}', or choose another plane");
  if (!kind.needsLongShell) return;
  const std::string right = "give physics: {shell: {ellipsoid: [3, 2, 2]}}, or choose another plane";
  if (!m.physics.shell) return refuse(name + " needs a shell", right);
  const auto& [a, b, c] = m.physics.shell->semiAxes;
  if (a == b && b == c) refuse("a sphere has no longest axis", right);
}

/// Where the value could not be read, that has been said.
bool hasNoDrag(const MechanicsScene& m, const Node& root) {
  if (m.physics.drag > 0) return false;
  const Node* given = inside(inside(&root, "physics"), "drag");
  Problems said("");
  return !given || readReal(*given, notNegative, "", "", said);
}

void checkChirality(const Chirality& chirality, bool mayBeNone, const MechanicsScene& m, const Node& root,
                    const Refuse& refuse) {
  if (chirality.angle == 0 && !mayBeNone)
    return refuse("an angle of 0 turns nothing", "remove it, or give an angle");
  if (!kindOf(m.physics.cell.model).hasMesh)
    refuse("a sphere looks the same when it has turned", "remove this");
  if (hasNoDrag(m, root))
    refuse("the medium turns daughters by its drag, and physics.drag is 0", "needs physics.drag > 0");
}

}  // namespace

void checkPlanes(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  const Node* division = inside(&root, "division");
  // Of defaults, the section is the place, or the file.
  const auto refusing = [&](const Node* part, std::initializer_list<const char*> keys, std::string path) {
    const Node* place = part ? part : &root;
    for (const char* key : keys)
      if (const Node* inner = inside(part, key)) place = inner;
    return [&reading, place, path](const std::string& wrong, const std::string& right) {
      reading.problems.add(place->place, path, wrong, right);
    };
  };
  checkPlane(m.division.otherwise, m, refusing(division, {"plane"}, "division.plane"));
  if (m.division.chirality)
    checkChirality(*m.division.chirality, false, m, root,
                   refusing(division, {"chirality"}, "division.chirality"));
  const Node* rules = inside(division, "rules");
  for (std::size_t i = 0; i < m.division.rules.size(); ++i) {
    const DivisionRule& rule = m.division.rules[i];
    const Node* node = rules && i < rules->items.size() ? &rules->items[i] : nullptr;
    const std::string path = "division.rules[" + std::to_string(i) + "]";
    if (rule.plane) checkPlane(*rule.plane, m, refusing(node, {"axis", "plane"}, path + ".plane"));
    if (rule.chirality)
      checkChirality(*rule.chirality, m.division.chirality.has_value(), m, root,
                     refusing(node, {"chirality"}, path + ".chirality"));
  }
}

}  // namespace morula::scenario

// How cells divide: rules that no cell can follow, and what cannot be done. Planes go by what a scene may lack: contacts,
// connections, a long shell. So does chirality, by drag.
#include <algorithm>

#include "base/number_text.h"
#include "base/random.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"
#include "division/rules.h"
#include "physics/cell_model.h"
#include "scenario/scene_checks.h"
#include "values/value_types.h"

namespace morula::scenario {
namespace {

std::string pathOf(std::size_t rule) { return "division.rules[" + std::to_string(rule) + "]"; }

class DivisionCheck {
 public:
  DivisionCheck(const Scenario& scenario, Reading& reading, const Node& root)
      : scene_(scenario.scene),
        division_(scenario.scene.mechanics->division),
        reading_(reading),
        root_(root),
        areSpheres_(!kindOf(scenario.scene.mechanics->physics.cell.model).hasMesh) {}

  void check() {
    const bool divides = canHold(substance::divide);
    if (divides && areSpheres_) checkPlane(division_.otherwise, placeOf(root_, "division.plane"), "division.plane");
    checkShare({}, placeOf(root_, "variation.share"), "variation.share");
    if (!divides) refuseUnused();
    if (reading_.rules.size() != division_.rules.size()) return;  // some could not be read, which has been said
    for (std::size_t i = 0; i < division_.rules.size(); ++i) {
      const DivisionRule& rule = division_.rules[i];
      const Place place = reading_.rules[i];
      if (rule.plane && areSpheres_) checkPlane(*rule.plane, place, pathOf(i) + ".plane");
      if (rule.share) checkShare(rule.share, place, pathOf(i) + ".share");
      if (const PlaneChoice& plane = rule.plane ? *rule.plane : division_.otherwise;
          rule.tilt && plane.plane == DivisionPlane::random)
        reading_.problems.add(place, pathOf(i) + ".tilt", "a random direction has nothing to be tilted from",
                              "remove this, or give the rule an axis or another plane");
      if (divides) checkCells(i, place);
    }
  }

 private:
  void checkPlane(const PlaneChoice& choice, const Place& place, const std::string& path) {
    if (kindOf(choice.plane).needsShape)
      reading_.problems.add(place, path, "a sphere has no longest extent", "needs " + planesAllowed(true));
  }

  /// What variation leads out of what can be cut.
  void checkShare(const std::optional<double>& given, const Place& place, const std::string& path) {
    const double share = given.value_or(0.5), most = largestDeviate * scene_.variation.share;
    if (!(most > 0) || (share - most >= leastShare && share + most <= largestShare)) return;
    reading_.problems.add(place, path,
                          exactText(share) + " ± 3 times variation.share leaves " + exactText(leastShare) + " to " +
                              exactText(largestShare) + ", which a cut can give",
                          "needs a share nearer to 0.5, or a smaller variation.share");
  }

  void refuseUnused() {
    if (scene_.dna.substances.empty()) return;  // it could not be read, which has been said
    const auto refuse = [&](const char* path) {
      reading_.problems.add(placeOf(root_, path), path, "no gene produces 'divide', so no cell ever divides",
                            "write a gene such as g1(divide|a0), or remove this");
    };
    if (!division_.rules.empty()) refuse("division.rules");
    if (scene_.variation.share > 0) refuse("variation.share");
    if (scene_.variation.tilt > 0) refuse("variation.tilt");
  }

  /// Whether a cell can hold this when it divides: its genes have just made all that it holds, but for what the
  /// simulator lets it sense, which neither it begins with nor a division gives it.
  bool canHold(const std::string& name) const {
    const Dna& dna = scene_.dna;
    const auto id = findSubstance(dna, name);
    if (!id || name == substance::a || name == substance::b || name == substance::die) return false;
    if (std::ranges::find(dna.genes, *id, &Gene::product) != dna.genes.end()) return true;
    const bool isActing = std::ranges::find(substance::acting, name) != substance::acting.end();
    return !isActing && std::ranges::find(dna.start, *id) == dna.start.end() &&
           std::ranges::none_of(reading_.substances, [&](const SubstanceUse& use) {
             return use.path.starts_with("cells") && use.name == name;
           });
  }

  /// Whether there are cells for a rule, and rules before it that take them all.
  void checkCells(std::size_t i, const Place& place) {
    const DivisionRule& rule = division_.rules[i];
    const std::string path = pathOf(i) + ".of";
    for (const std::string& pattern : rule.of) {
      const auto isMeant = [&](const std::string& s) { return fits(pattern, s); };
      if (std::ranges::none_of(scene_.dna.substances, isMeant)) return;  // unknown, which has been said
      if (std::ranges::any_of(scene_.dna.substances, [&](const std::string& s) { return isMeant(s) && canHold(s); }))
        continue;
      reading_.problems.add(place, path, "no cell that divides holds '" + pattern + "': " + whyNever(pattern),
                            "needs a substance that cells hold when they divide");
      return;
    }
    for (std::size_t before = 0; before < i; ++before)
      if (!division_.rules[before].of.empty() && takesAllOf(division_.rules[before], rule)) {
        reading_.problems.add(place, path, pathOf(before) + " takes all its cells before it",
                              "put this rule before that one, or remove it");
        return;
      }
  }

  static std::string whyNever(const std::string& pattern) {
    if (pattern == substance::a || pattern == substance::b)
      return "it is gone after the cell's first cycle, and a division follows a cycle";
    if (pattern == substance::die) return "who holds it dies";
    return "no gene produces it";
  }

  static bool takesAllOf(const DivisionRule& wide, const DivisionRule& narrow) {
    return std::ranges::all_of(wide.of, [&](const std::string& w) {
      return std::ranges::any_of(narrow.of, [&](const std::string& n) { return includes(w, n); });
    });
  }

  const Scene& scene_;
  const DivisionParameters& division_;
  Reading& reading_;
  const Node& root_;
  const bool areSpheres_;
};

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

void checkDivision(const Scenario& scenario, Reading& reading, const Node& root) {
  DivisionCheck(scenario, reading, root).check();
}

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

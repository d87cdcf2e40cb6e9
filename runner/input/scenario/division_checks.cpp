// Checks of how cells divide: rules that no cell can follow, and impossible cuts. Planes and chirality are checked
// against the scene: contacts, connections, a long shell, drag.
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
  explicit DivisionCheck(const SceneCheck& check)
      : check_(check),
        division_(check.mechanics().division),
        areSpheres_(!kindOf(check.physics().cell.model).hasMesh) {}

  void run() {
    const bool divides = canHold(substance::divide);
    if (divides && areSpheres_)
      checkPlane(division_.otherwise, placeOf(check_.root, "division.plane"), "division.plane");
    checkShare({}, placeOf(check_.root, "variation.share"), "variation.share");
    if (!divides) refuseUnused();
    if (check_.reading.rules.size() != division_.rules.size()) return;  // an unreadable rule has been reported
    for (std::size_t i = 0; i < division_.rules.size(); ++i) {
      const DivisionRule& rule = division_.rules[i];
      const Place place = check_.reading.rules[i];
      if (rule.plane && areSpheres_) checkPlane(*rule.plane, place, pathOf(i) + ".plane");
      if (rule.share) checkShare(rule.share, place, pathOf(i) + ".share");
      if (const PlaneChoice& plane = rule.plane ? *rule.plane : division_.otherwise;
          rule.tilt && plane.plane == DivisionPlane::random)
        check_.reading.problems.add(place, pathOf(i) + ".tilt", "a random direction cannot be tilted",
                                    "remove this, or give the rule an axis or another plane");
      if (divides) checkCells(i, place);
    }
  }

 private:
  void checkPlane(const PlaneChoice& choice, const Place& place, const std::string& path) {
    if (kindOf(choice.plane).needsShape)
      check_.reading.problems.add(place, path, "a sphere has no longest extent", "needs " + planesAllowed(true));
  }

  /// Checks that no variation leads to a share that cannot be cut.
  void checkShare(const std::optional<double>& given, const Place& place, const std::string& path) {
    const double share = given.value_or(0.5), most = largestDeviate * check_.scene().variation.share;
    if (!(most > 0) || (share - most >= minShare && share + most <= largestShare)) return;
    check_.reading.problems.add(place, path,
                                exactText(share) + " ± 3 times variation.share is not within " + exactText(minShare) +
                                    " to " + exactText(largestShare) + ", the shares that a cut can give",
                                "needs a share nearer to 0.5, or a smaller variation.share");
  }

  void refuseUnused() {
    if (check_.scene().dna.substances.empty()) return;  // an unreadable DNA has been reported
    const VariationParameters& variation = check_.scene().variation;
    for (const auto& [path, isGiven] : {std::pair("division.rules", !division_.rules.empty()),
                                        {"variation.share", variation.share > 0},
                                        {"variation.tilt", variation.tilt > 0}})
      if (isGiven)
        check_.refuse(path, "no gene produces 'divide', so no cell ever divides",
                      "write a gene such as g1(divide|a0), or remove this");
  }

  /// Returns true if a cell can hold the substance when it divides: if a gene makes it, or if the simulator lets cells
  /// sense it. No start and no division gives a sensed substance.
  bool canHold(const std::string& name) const {
    const Dna& dna = check_.scene().dna;
    const auto id = findSubstance(dna, name);
    if (!id || name == substance::a || name == substance::b || name == substance::die) return false;
    if (std::ranges::find(dna.genes, *id, &Gene::product) != dna.genes.end()) return true;
    const bool isActing = std::ranges::find(substance::acting, name) != substance::acting.end();
    return !isActing && std::ranges::find(dna.start, *id) == dna.start.end() &&
           std::ranges::none_of(check_.reading.substances, [&](const SubstanceUse& use) {
             return use.path.starts_with("cells") && use.name == name;
           });
  }

  /// Checks that there are cells for a rule, and that no rules before it take them all.
  void checkCells(std::size_t i, const Place& place) {
    const DivisionRule& rule = division_.rules[i];
    const std::string path = pathOf(i) + ".of";
    for (const std::string& pattern : rule.of) {
      const auto isMeant = [&](const std::string& s) { return fits(pattern, s); };
      if (std::ranges::none_of(check_.scene().dna.substances, isMeant)) return;  // reported as unknown
      if (std::ranges::any_of(check_.scene().dna.substances,
                              [&](const std::string& s) { return isMeant(s) && canHold(s); }))
        continue;
      check_.reading.problems.add(place, path, "no cell that divides holds '" + pattern + "': " + whyNever(pattern),
                                  "needs a substance that cells hold when they divide");
      return;
    }
    for (std::size_t before = 0; before < i; ++before)
      if (!division_.rules[before].of.empty() && takesAllOf(division_.rules[before], rule)) {
        check_.reading.problems.add(place, path, pathOf(before) + " applies to all its cells first",
                                    "put this rule before the other one, or remove this rule");
        return;
      }
  }

  static std::string whyNever(const std::string& pattern) {
    if (pattern == substance::a || pattern == substance::b)
      return "the substance is gone after the cell's first cycle, and a division follows a cycle";
    if (pattern == substance::die) return "a cell that holds it dies";
    return "no gene produces it";
  }

  static bool takesAllOf(const DivisionRule& wide, const DivisionRule& narrow) {
    return wide.cells.empty() && std::ranges::all_of(wide.of, [&](const std::string& w) {
      return std::ranges::any_of(narrow.of, [&](const std::string& n) { return includes(w, n); });
    });
  }

  const SceneCheck& check_;
  const DivisionParameters& division_;
  const bool areSpheres_;
};

/// Adds a problem: what is wrong, and what would be right.
using Refuse = std::function<void(const std::string& wrong, const std::string& right)>;

void checkPlane(const PlaneChoice& choice, const MechanicsScene& m, const Refuse& refuse) {
  const DivisionPlaneKind& kind = kindOf(choice.plane);
  const std::string name = kind.name;
  const bool turns = kind.takes == Takes::polarity && !choice.substance.empty();
  if ((kind.needsContact || turns) && !m.contact)
    refuse(name + (turns ? " turns with contacts" : " depends on contacts") +
               ", and without physics.contact cells have none",
           "add 'contact: {}' to physics, or choose another plane");
  if (kind.needsConnections && !m.connections)
    refuse(name + " depends on connections, and without a section connections cells have none",
           "add 'connections: {}', or choose another plane");
  if (!kind.needsLongShell) return;
  const std::string right = "give physics: {shell: {ellipsoid: [3, 2, 2]}}, or choose another plane";
  if (!m.physics.shell) return refuse(name + " needs a shell", right);
  if (m.physics.shell->mesh) return refuse("a shell that is a mesh has no semi-axes", right);
  const auto& [a, b, c] = m.physics.shell->semiAxes;
  if (a == b && b == c) refuse("a sphere has no longest axis", right);
}

/// Returns true if the scene has no drag. An unreadable value has been reported.
bool hasNoDrag(const SceneCheck& check) {
  if (check.physics().drag > 0) return false;
  const Node* drag = given(check.root, "physics.drag");
  Problems said("");
  return !drag || readReal(*drag, notNegative, "", "", said);
}

void checkChirality(const Chirality& chirality, bool mayBeNone, const SceneCheck& check, const Refuse& refuse) {
  if (chirality.angle == 0 && !mayBeNone)
    return refuse("an angle of 0 turns no daughter", "remove it, or give an angle");
  if (!kindOf(check.physics().cell.model).hasMesh) refuse("a sphere looks the same when it has turned", "remove this");
  if (hasNoDrag(check))
    refuse("the medium turns daughters by its drag, and physics.drag is 0", "needs physics.drag > 0");
}

}  // namespace

void checkDivision(const SceneCheck& check) { DivisionCheck(check).run(); }

void checkPlanes(const SceneCheck& check) {
  const DivisionParameters& division = check.mechanics().division;
  const auto at = [&](const std::string& path) -> Refuse {
    return [&check, path](const std::string& wrong, const std::string& right) { check.refuse(path, wrong, right); };
  };
  checkPlane(division.otherwise, check.mechanics(), at("division.plane"));
  if (division.chirality) checkChirality(*division.chirality, false, check, at("division.chirality"));
  if (check.reading.rules.size() != division.rules.size()) return;  // an unreadable rule has been reported
  for (std::size_t i = 0; i < division.rules.size(); ++i) {
    const DivisionRule& rule = division.rules[i];
    const auto of = [&](const char* key) -> Refuse {
      return [&, path = pathOf(i) + key](const std::string& wrong, const std::string& right) {
        check.reading.problems.add(check.reading.rules[i], path, wrong, right);
      };
    };
    if (rule.plane) checkPlane(*rule.plane, check.mechanics(), of(".plane"));
    if (rule.chirality) checkChirality(*rule.chirality, division.chirality.has_value(), check, of(".chirality"));
  }
}

}  // namespace morula::scenario

// Checks that the table cannot make: values that do not fit each other, the DNA or the start cells.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"
#include "files/text.h"
#include "observation/asked_measure.h"
#include "physics/integrator.h"
#include "scenario/bullet_fit.h"
#include "scenario/scene_checks.h"
#include "simulation/cycle_lengths.h"
#include "simulation/simulation.h"
#include "simulation/start_variation.h"
#include "values/measure_list.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

/// Returns the parameter's value and true; or the innermost map on its path that is given, and false.
std::pair<const Node*, bool> innermost(const Node& root, const std::string& path) {
  const Node* node = &root;
  for (const std::string& key : partsOf(path, '.')) {
    const auto* member = node->find(key);
    if (!member) return {node, false};
    node = &member->value;
  }
  return {node, true};
}

}  // namespace

Place placeOf(const Node& root, const std::string& path) { return innermost(root, path).first->place; }

const Node* given(const Node& root, const std::string& path) {
  const auto [node, isWhole] = innermost(root, path);
  return isWhole ? node : nullptr;
}

namespace {

constexpr double slack = 1e-9;  // [1] rounding error of a shell that just fits

void checkSubstances(const SceneCheck& check) {
  const Dna& dna = check.scene().dna;
  if (dna.substances.empty()) return;  // an unreadable DNA has been reported
  for (const auto& use : check.reading.substances) {
    const auto isMeant = [&](const std::string& s) { return use.isPattern ? fits(use.name, s) : s == use.name; };
    if (std::ranges::any_of(dna.substances, isMeant)) continue;
    if (use.isPattern) {
      check.reading.problems.add(
          use.place, use.path, "no substance of the DNA begins with '" + use.name.substr(0, use.name.size() - 1) + "'",
          "needs a name, or its beginning and '*'");
      continue;
    }
    const auto near = closest(use.name, dna.substances);
    check.reading.problems.add(use.place, use.path, "the DNA has no substance '" + use.name + "'",
                               near.empty() ? "needs a name that occurs in the DNA" : "did you mean " + near + "?");
  }
}

/// Returns the distance of the egg's farthest vertex from the origin [radii of the egg], at least 1.
double farthestOf(const MechanicsScene& mechanics) {
  double farthest = mechanics.physics.cell.radius;
  for (const Point& vertex : mechanics.mesh.vertices) farthest = std::max(farthest, norm(vertex));
  return farthest / mechanics.physics.cell.radius;
}

/// Returns how far out the egg's shape reaches [radii of the egg]. An icosphere counts as the sphere that it
/// approximates: its vertices lie slightly outside, and the shell moves them onto itself in the first step.
double reachOf(const Scenario& scenario) {
  return scenario.mesh.file && !scenario.mesh.icosphere ? farthestOf(*scenario.scene.mechanics) : 1;
}

/// Returns the smallest semi-axis [length].
double smallestAxis(const ShellParameters& shell) {
  return std::min({shell.semiAxes[0], shell.semiAxes[1], shell.semiAxes[2]});
}

/// Adds the problem that the egg is too large. `most`: max reach [length]; `whose`: the length of the shell, in words.
void refuseRadius(const SceneCheck& check, double most, const std::string& whose) {
  const double reach = reachOf(check.scenario);
  std::string where = whose + ", " + exactText(most) + " [length]";
  if (reach > 1)
    where += ", over " + numberText(reach) +
             ", because the shape reaches that many radii from its "
             "centre";
  check.refuse("physics.cell.radius", exactText(check.physics().cell.radius) + " does not fit into the shell",
               "needs at most " + where);
}

/// Checks that the egg, a sphere, fits a shell that is a mesh.
void checkMeshShell(const SceneCheck& check) {
  const PhysicsParameters& physics = check.physics();
  double nearest = INFINITY;
  for (const ShellPlane& plane : physics.shell->mesh->planes) nearest = std::min(nearest, plane.offset);
  const double share = nearest / (physics.cell.radius * reachOf(check.scenario));
  if (share >= 1 - slack) return;
  const auto& fill = check.scenario.shellFill;
  if (!fill) return refuseRadius(check, nearest, "the distance of the nearest face from the origin");
  const double most = *fill * share * share * share;
  check.refuse("physics.shell.fill",
               exactText(*fill) + " is more than a round egg can fill of this mesh without standing out of it",
               "needs at most " + numberText(std::floor(1e4 * most) / 1e4));
}

void checkShell(const SceneCheck& check) {
  const PhysicsParameters& physics = check.physics();
  if (physics.shell && physics.cell.radius * reachOf(check.scenario) > smallestAxis(*physics.shell))
    refuseRadius(check, smallestAxis(*physics.shell), "the shell's smallest semi-axis");
}

/// Checks that each start cell with a body has a place, and that none without a body has anything but substances.
void checkPlacesOfStart(const SceneCheck& check) {
  const Node* cells = given(check.root, "cells");
  if (!cells || cells->kind != Node::Kind::sequence) return;
  for (std::size_t i = 0; i < cells->items.size(); ++i) {
    const Node& cell = cells->items[i];
    const std::string path = "cells[" + std::to_string(i) + "].";
    if (cell.kind != Node::Kind::map) continue;
    if (check.scene().mechanics && !cell.find("at"))
      check.reading.problems.add(cell.place, path + "at", "is missing", "needs its centre, as at: [0, 0, 0]");
    if (check.scene().mechanics) continue;
    for (const Member& member : cell.members)
      if (member.key != "substances")
        check.reading.problems.add(member.place, path + member.key, "has no effect without physics",
                                   "add 'physics: {}', or remove this");
  }
}

void checkStartCells(const SceneCheck& check) {
  const auto& cells = check.scene().cells;
  const auto& shell = check.physics().shell;
  if (!shell || check.reading.startCells.size() != cells.size()) return;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (outermostSquare(cells[i], check.mechanics().mesh, *shell) > 1 + slack)
      check.reading.problems.add(check.reading.startCells[i], "cells[" + std::to_string(i) + "]",
                                 "stands out of the shell", "move it inward, or make it or its stretch smaller");
}

/// Checks `fill` of an egg with the shell's shape: a polyhedron in the shell cannot fill as much as a smooth egg.
void checkFill(const SceneCheck& check) {
  if (!check.physics().shell) return;
  const double reach = farthestOf(check.mechanics());  // [1] over the radius of a sphere of equal volume
  const double most = 1 / (reach * reach * reach), fill = *check.scenario.shellFill;
  if (fill <= most) return;
  check.refuse("physics.shell.fill",
               exactText(fill) + " is more than the egg's mesh can fill without standing out of the shell",
               "needs at most " + numberText(std::floor(1000 * most) / 1000) + ", or a finer physics.mesh");
}

/// Checks that the egg or the start cells fit the shell.
void checkFit(const SceneCheck& check) {
  const Scenario& s = check.scenario;
  const auto& shell = check.physics().shell;
  if (shell && s.shellMesh && !shell->mesh) return;  // an unreadable mesh has been reported
  if (shell && shell->mesh && s.scene.cells.empty()) checkMeshShell(check);
  else if (s.eggIsStretched || (s.shellFill && s.scene.cells.empty() && kindOf(check.physics().cell.model).hasMesh))
    checkFill(check);
  else if (s.scene.cells.empty()) checkShell(check);
  else checkStartCells(check);
}

void checkIntegrator(const SceneCheck& check) {
  const PhysicsParameters& physics = check.physics();
  const auto& contact = check.mechanics().contact;
  const bool xpbd = physics.integrator == Integrator::xpbd;
  if (!xpbd && physics.substeps.value_or(1) > 1)
    check.refuse("physics.substeps", "is for physics.integrator xpbd: others evaluate forces once per time step",
                 "remove this key, or give integrator: xpbd");
  if (xpbd && kindOf(physics.cell.model).hasMembrane && physics.membrane.bending > 0)
    check.refuse("physics.membrane.bending", "is not computed by integrator xpbd",
                 "remove this, or use another integrator");
  if (xpbd && !physics.timeStep && !(contact && contact->law != ContactLaw::thesis))
    check.refuse("physics.time_step",
                 "auto follows stability limits, and integrator xpbd has only that of pair contacts",
                 "needs a number > 0 [time]");
}

/// Checks that no parameters are given for parts that the bodies lack.
void checkModel(const SceneCheck& check) {
  const PhysicsParameters& physics = check.physics();
  const auto refuse = [&](const std::string& path, const std::string& wrong, const std::string& right) {
    if (given(check.root, path)) check.refuse(path, wrong, right);
  };
  const CellModelKind& kind = kindOf(physics.cell.model);
  if (kind.hasMembrane)
    return refuse("physics.shape-matching", "is for physics.cell.model shape-matching",
                  "remove this, or give cell: {model: shape-matching}");
  const std::string model = nameOf(physics.cell.model);
  const std::string lacking = ", which cells of model " + model + " do not have";
  for (const char* path : {"physics.membrane", "physics.pressure"})
    refuse(path, "is for physics.cell.model shell, and here it is " + model,
           kind.hasRestShape ? "remove this; see physics.shape-matching" : "remove this");
  if (!kind.hasRestShape)
    refuse("physics.shape-matching", "is for physics.cell.model shape-matching, and here it is " + model,
           "remove this");
  if (kindOf(physics.integrator).solvesForces)
    refuse("physics.integrator", "xpbd solves membranes and contents" + lacking, "needs another integrator");
  if (check.scenario.check.energy)
    refuse("check.energy", "is the energy of membranes and contents" + lacking, "remove this");
}

/// Checks that spheres are given no part that they lack, and asked for nothing that they cannot do.
void checkSpheres(const SceneCheck& check) {
  const auto& contact = check.mechanics().contact;
  const auto& cells = check.scene().cells;
  if (kindOf(check.physics().cell.model).hasMesh) return;
  if (check.physics().coarsen) check.refuse("physics.mesh.coarsen", "a sphere has no mesh to coarsen", "remove this");
  if (contact && contact->law == ContactLaw::thesis)
    check.refuse("physics.contact.law", "the thesis' law acts between vertices, which spheres do not have",
                 "needs pair");
  if (contact && contact->radius != ContactParameters{}.radius)
    check.refuse("physics.contact.radius", "spheres touch where their surfaces do", "remove this");
  for (std::size_t i = 0; i < cells.size() && i < check.reading.startCells.size(); ++i) {
    const auto refuse = [&](const char* key, const char* why, const char* remedy) {
      check.reading.problems.add(check.reading.startCells[i], "cells[" + std::to_string(i) + "]." + key, why, remedy);
    };
    if (cells[i].stretch != Vector{1, 1, 1}) refuse("stretch", "a sphere stays round", "remove this, or use scale");
    if (cells[i].turn != Vector{}) refuse("turn", "a sphere has no mesh to turn", "remove this");
  }
}

/// Checks that variations of bodies are given only in scenes with bodies.
void checkVariation(const SceneCheck& check) {
  const VariationParameters& v = check.scene().variation;
  if (!check.scene().mechanics) {
    const std::pair<const char*, double> ofBodies[] = {{"variation.share", v.share},
                                                       {"variation.start", v.start},
                                                       {"variation.tilt", v.tilt},
                                                       {"variation.adhesion", v.adhesion}};
    for (const auto& [path, sd] : ofBodies)
      if (sd > 0)
        check.refuse(path, "cells without bodies have nothing to vary", "add a physics block, or remove this");
    return;
  }
  const auto& contact = check.mechanics().contact;
  if (v.adhesion > 0 && !(contact && contact->adhesion))
    check.refuse("variation.adhesion", "cells stick to each other only with physics.contact.adhesion",
                 "give physics.contact.adhesion, or remove this");
  const PhysicsParameters& physics = check.physics();
  if (!(v.start > 0) || !physics.shell || !check.scene().cells.empty()) return;
  if (physics.cell.radius * reachOf(check.scenario) >= smallestAxis(*physics.shell))
    check.refuse("variation.start", "the egg fills the shell, so it has no other place",
                 "remove this, or give a smaller physics.cell.radius");
}

/// Checks that a reason is given if, and only if, an end need not be sane.
void checkReason(const SceneCheck& check) {
  const CheckParameters& c = check.scenario.check;
  if (!c.sane && c.because.empty() && !given(check.root, "check.because"))
    check.refuse("check.sane", "false needs a reason",
                 "give the reason beside it, as because: \"what the scene is "
                 "about\"");
  if (c.sane && !c.because.empty())
    check.refuse("check.because", "gives a reason for sane: false, and sane is true",
                 "remove check.because, or write sane: false");
}

/// Checks the length of each text: a text of a letter or two is part of nearly every message.
void checkFails(const SceneCheck& check) {
  constexpr std::ptrdiff_t minLetters = 3;
  for (const std::string& text : check.scenario.check.fails)
    if (std::ranges::count_if(text, [](unsigned char c) { return c >= 0x80 || std::isalnum(c); }) < minLetters)
      check.refuse("check.fails", "'" + text + "' is part of nearly every message",
                   "give words that name the reason, with at least 3 letters or digits");
}

/// Checks that an interval makes at most `most` of `of`: more could not be stored or viewed in reasonable time.
void checkInterval(const SceneCheck& check, const std::string& path, std::optional<double> every, double most,
                   const std::string& of) {
  const auto end = plannedEnd(check.scene());
  if (every && end && *end / *every > most)
    check.refuse(path,
                 exactText(*every) + " makes more than " + exactText(most) + " " + of + " until the run's end at " +
                     exactText(*end),
                 "needs at least " + exactText(*end / most) + " [time]");
}

/// Checks that the scene has what record.measures asks for, and that a measure asks for what check.reference gives.
void checkMeasures(const SceneCheck& check) {
  const RecordParameters& record = check.scenario.record;
  std::set<Needs> asked;
  for (const std::string& name : record.measures) {
    for (const AskedMeasure& m : findMeasure(name)->terms()) {
      asked.insert(m.needs);
      if (const std::string lacking = lackingFor(m.needs, check.scenario); !lacking.empty())
        check.refuse("record.measures", m.name + " would find nothing to measure", "needs " + lacking);
    }
  }
  const auto isDuration = [](const std::string& name) { return name.find("contact_duration") != name.npos; };
  if (std::ranges::any_of(record.measures, isDuration) && !record.every && !record.meshes && record.atCells.empty() &&
      check.scene().cells.empty())
    check.refuse("record.measures",
                 "contact_duration would always be 0, because no sample is taken between the egg and the end",
                 "needs record.every or record.at-cells");
  const auto& reference = check.scenario.check.reference;
  if (!reference) return;
  for (const auto& [needs, key, given, by] :
       {std::tuple(Needs::referenceContacts, "check.reference.contacts", !reference->contacts.empty(),
                   "contact_jaccard or contact_f1"),
        std::tuple(Needs::referencePositions, "check.reference.positions", !reference->positions.empty(),
                   "position_rmsd or position_shape_rmsd")})
    if (given && !asked.contains(needs))
      check.refuse(key, "no measure compares with this reference",
                   std::string("name ") + by + " in record.measures, or remove it");
}

void checkBodies(const SceneCheck& check) {
  checkFit(check);
  // Without outside pressure, contents have no volume at rest from which their energy could count.
  if (check.scenario.check.energy && check.physics().pressure.outside == 0)
    check.refuse("check.energy", "the energy has no zero if physics.pressure.outside is 0",
                 "give a pressure > 0, or remove this");
  if (check.physics().coarsen && check.scenario.mesh.icosphere && check.mechanics().coarser.empty())
    check.refuse("physics.mesh.coarsen", "the egg's mesh is already the coarsest",
                 "needs icosphere 3 or 4, or remove this");
  checkModel(check);
  checkIntegrator(check);
  checkSettling(check);
  checkSpheres(check);
  checkDivision(check);
  checkConnections(check);
  checkPlanes(check);
  checkAdhesion(check);
  checkMotility(check);
  if (const auto& bullet = check.scenario.check.bullet)
    for (const Incompatibility& one : bulletIncompatibilities(check.scenario, bullet->baseline))
      check.refuse("check.bullet", one.wrong, one.right);
  checkDivisionSize(check);
}

}  // namespace

std::vector<std::string> intervalWarnings(const Scenario& scenario, const Node& root) {
  const auto& mechanics = scenario.scene.mechanics;
  if (!mechanics || !kindOf(mechanics->physics.integrator).settles) return {};
  const double shortest = shortestCycle(scenario.scene).length;
  const RecordParameters& record = scenario.record;
  std::vector<std::string> warnings;
  for (const auto& [key, every] : {std::pair("record.every", record.every), std::pair("record.meshes", record.meshes),
                                   std::pair("record.pictures", record.pictures)})
    if (every && *every < shortest)
      warnings.push_back(placeText(scenario.file, placeOf(root, key)) + ": " + key + ": " + exactText(*every) +
                         " is shorter than every cell cycle, but with physics.integrator: " +
                         std::string(nameOf(mechanics->physics.integrator)) +
                         " nothing happens "
                         "between cell cycles. Each of these times is sampled at the first cell cycle at or after "
                         "it, and times with the same cycle are sampled once");
  return warnings;
}

void crossCheck(const Scenario& scenario, Reading& reading, const Node& root) {
  const SceneCheck check{scenario, reading, root};
  const RecordParameters& record = scenario.record;
  checkSubstances(check);
  checkCellNames(scenario, reading, root);
  if (reading.problems.empty()) checkMeasures(check);
  checkReason(check);
  checkPlacesOfStart(check);
  if (scenario.scene.mechanics) checkBodies(check);
  checkVariation(check);
  checkSenses(check);
  checkFirstCycle(check);
  checkInterval(check, "record.every", record.every, 1e7, "samples");
  checkInterval(check, "record.pictures", record.pictures, 1e5, "pictures");
  checkInterval(check, "record.meshes", record.meshes, 1e6, "samples of surfaces");
  checkFails(check);
  if (scenario.scene.mechanics) return;
  if (record.meshes)
    check.refuse("record.meshes", "cells without bodies have no surfaces", "add a physics block or remove this");
  if (record.pictures)
    check.refuse("record.pictures", "cells without bodies cannot be drawn", "add a physics block or remove this");
  if (const CheckParameters& c = scenario.check; c.volume || c.extent || c.energy || c.momentum || c.endVolume ||
                                                 c.endRoundness || c.endOverlap || c.bullet || !c.sane)
    check.refuse("check", "cells without bodies have nothing to measure", "add a physics block, or check only fails");
}

}  // namespace morula::scenario

// What the table cannot say: values that do not fit each other, the DNA or the start cells.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "base/did_you_mean.h"
#include "base/number_text.h"
#include "biology/substance_pattern.h"
#include "biology/substances.h"
#include "physics/integrator.h"
#include "scenario/bullet_fit.h"
#include "scenario/scene_checks.h"
#include "simulation/asked_measure.h"
#include "simulation/start_variation.h"
#include "simulation/world.h"
#include "values/measure_list.h"
#include "yaml/numbers.h"

namespace morula::scenario {
namespace {

/// The parameter's value, or that of the innermost map that is given; `whole`: whether it is the parameter's.
const Node& innermost(const Node& root, const std::string& path, bool& whole) {
  const Node* node = &root;
  for (std::size_t begin = 0; begin < path.size();) {
    const auto end = std::min(path.find('.', begin), path.size());
    const auto* member = node->find(path.substr(begin, end - begin));
    whole = member != nullptr;
    if (!member) break;
    node = &member->value;
    begin = end + 1;
  }
  return *node;
}

}  // namespace

Place placeOf(const Node& root, const std::string& path) {
  bool whole = true;
  return innermost(root, path, whole).place;
}

const Node* given(const Node& root, const std::string& path) {
  bool whole = true;
  const Node& node = innermost(root, path, whole);
  return whole ? &node : nullptr;
}

namespace {

void checkSubstances(const Dna& dna, Reading& reading) {
  if (dna.substances.empty()) return;  // it could not be read, which has been said
  for (const auto& use : reading.substances) {
    const auto isMeant = [&](const std::string& s) { return use.isPattern ? fits(use.name, s) : s == use.name; };
    if (std::ranges::any_of(dna.substances, isMeant)) continue;
    if (use.isPattern) {
      reading.problems.add(use.place, use.path,
                           "no substance of the DNA begins with '" + use.name.substr(0, use.name.size() - 1) + "'",
                           "needs a name, or its beginning and '*'");
      continue;
    }
    const auto near = closest(use.name, dna.substances);
    reading.problems.add(use.place, use.path, "the DNA has no substance '" + use.name + "'",
                         near.empty() ? "needs a name that occurs in the DNA" : "did you mean " + near + "?");
  }
}

/// [1] How far out the egg's shape reaches, in its radii. An icosphere counts as the sphere that it stands
/// for: its vertices lie a little farther out, and the shell puts them onto itself in the first step.
double reachOf(const Scenario& scenario) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  double farthest = mechanics.physics.cell.radius;
  if (scenario.mesh.file && !scenario.mesh.icosphere)
    for (const Point& vertex : mechanics.mesh.vertices) farthest = std::max(farthest, norm(vertex));
  return farthest / mechanics.physics.cell.radius;
}

/// The egg is a sphere, whatever the mesh of its shell.
void checkMeshShell(const Scenario& scenario, Reading& reading, const Node& root) {
  const PhysicsParameters& physics = scenario.scene.mechanics->physics;
  double nearest = INFINITY;
  for (const ShellPlane& plane : physics.shell->mesh->planes) nearest = std::min(nearest, plane.offset);
  const double reach = reachOf(scenario), share = nearest / (physics.cell.radius * reach);
  constexpr double rounding = 1e-9;
  if (share >= 1 - rounding) return;
  if (scenario.shellFill) {
    const double most = *scenario.shellFill * share * share * share;
    return reading.problems.add(
        placeOf(root, "physics.shell.fill"), "physics.shell.fill",
        exactText(*scenario.shellFill) + " is more than a round egg can fill of this mesh without standing out of it",
        "needs at most " + numberText(std::floor(1e4 * most) / 1e4));
  }
  std::string where = "the distance of the nearest face from the origin, " + exactText(nearest) + " [length]";
  if (reach > 1) where += ", over " + numberText(reach) + ", for the shape reaches so many radii from its centre";
  reading.problems.add(placeOf(root, "physics.cell.radius"), "physics.cell.radius",
                       exactText(physics.cell.radius) + " does not fit into the shell", "needs at most " + where);
}

void checkShell(const Scenario& scenario, Reading& reading, const Node& root) {
  const PhysicsParameters& physics = scenario.scene.mechanics->physics;
  if (!physics.shell) return;
  const auto& axes = physics.shell->semiAxes;
  const double smallest = std::min({axes[0], axes[1], axes[2]}), reach = reachOf(scenario);
  if (physics.cell.radius * reach <= smallest) return;
  std::string where = "its smallest semi-axis, " + exactText(smallest) + " [length]";
  if (reach > 1) where += ", over " + numberText(reach) + ", for the shape reaches so many radii from its centre";
  reading.problems.add(placeOf(root, "physics.cell.radius"), "physics.cell.radius",
                       exactText(physics.cell.radius) + " does not fit into the shell", "needs at most " + where);
}

void checkStartCells(const Scenario& scenario, Reading& reading) {
  constexpr double rounding = 1e-9;
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (!mechanics.physics.shell || reading.startCells.size() != scenario.scene.cells.size()) return;
  for (std::size_t i = 0; i < scenario.scene.cells.size(); ++i)
    if (outermostSquare(scenario.scene.cells[i], mechanics.mesh, *mechanics.physics.shell) > 1 + rounding)
      reading.problems.add(reading.startCells[i], "cells[" + std::to_string(i) + "]", "stands out of the shell",
                           "move it inward, or make it or its stretch smaller");
}

/// An egg with the shell's shape is a polyhedron in it, and cannot fill as much as a smooth one.
void checkFill(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (!mechanics.physics.shell) return;
  double farthest = mechanics.physics.cell.radius;
  for (const Point& vertex : mechanics.mesh.vertices) farthest = std::max(farthest, norm(vertex));
  const double reach = farthest / mechanics.physics.cell.radius;  // of its vertices, over the sphere's of its volume
  const double most = 1 / (reach * reach * reach);
  if (*scenario.shellFill <= most) return;
  reading.problems.add(
      placeOf(root, "physics.shell.fill"), "physics.shell.fill",
      exactText(*scenario.shellFill) + " is more than the egg's mesh can fill without standing out of the shell",
      "needs at most " + numberText(std::floor(1000 * most) / 1000) + ", or a finer physics.mesh");
}

/// Contents that nothing presses on have no volume at rest to measure their energy from.
void checkEnergy(const Scenario& scenario, Reading& reading, const Node& root) {
  if (scenario.check.energy && scenario.scene.mechanics->physics.pressure.outside == 0)
    reading.problems.add(placeOf(root, "check.energy"), "check.energy",
                         "has no zero to count from where physics.pressure.outside is 0",
                         "give a pressure > 0, or remove this");
}

void checkCoarsening(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& mechanics = *scenario.scene.mechanics;
  if (mechanics.physics.coarsen && scenario.mesh.icosphere && mechanics.coarser.empty())
    reading.problems.add(placeOf(root, "physics.mesh.coarsen"), "physics.mesh.coarsen",
                         "the egg's mesh is already the coarsest", "needs icosphere 3 or 4, or remove this");
}

void checkIntegrator(const PhysicsParameters& physics, bool hasPairContact, Reading& reading, const Node& root) {
  const bool xpbd = physics.integrator == Integrator::xpbd;
  if (!xpbd && physics.substeps.value_or(1) > 1)
    reading.problems.add(placeOf(root, "physics.substeps"), "physics.substeps",
                         "is for physics.integrator xpbd: others evaluate forces once per time step",
                         "remove this, or give integrator: xpbd");
  if (xpbd && !physics.timeStep && !hasPairContact)
    reading.problems.add(placeOf(root, "physics.time_step"), "physics.time_step",
                         "auto goes by stability limits, and integrator xpbd has none but that of pair contacts",
                         "needs a number > 0 [time]");
}

/// What a body is not made of has no parameters.
void checkModel(const Scenario& scenario, Reading& reading, const Node& root) {
  const PhysicsParameters& physics = scenario.scene.mechanics->physics;
  const auto refuse = [&](const std::string& path, const std::string& wrong, const std::string& right) {
    if (const Node* node = given(root, path)) reading.problems.add(node->place, path, wrong, right);
  };
  const CellModelKind& kind = kindOf(physics.cell.model);
  if (kind.hasMembrane) {
    refuse("physics.shape-matching", "is for physics.cell.model shape-matching",
           "remove this, or give cell: {model: shape-matching}");
    return;
  }
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
  if (scenario.check.energy) refuse("check.energy", "is of membranes and contents" + lacking, "remove this");
}

/// What a sphere has not, and what it cannot do.
void checkSpheres(const Scenario& scenario, Reading& reading, const Node& root) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  if (kindOf(m.physics.cell.model).hasMesh) return;
  const auto refuse = [&](const std::string& path, const char* wrong, const std::string& right) {
    reading.problems.add(placeOf(root, path), path, wrong, right);
  };
  if (m.physics.coarsen) refuse("physics.mesh.coarsen", "a sphere has no mesh to coarsen", "remove this");
  if (m.contact && m.contact->law == ContactLaw::thesis)
    refuse("physics.contact.law", "the thesis' law is between vertices, which spheres have not", "needs pair");
  if (m.contact && m.contact->radius != ContactParameters{}.radius)
    refuse("physics.contact.radius", "spheres touch where their surfaces do", "remove this");
  for (std::size_t i = 0; i < scenario.scene.cells.size() && i < reading.startCells.size(); ++i)
    if (const Vector& s = scenario.scene.cells[i].stretch; s.x != 1 || s.y != 1 || s.z != 1)
      reading.problems.add(reading.startCells[i], "cells[" + std::to_string(i) + "].stretch", "a sphere stays round",
                           "remove this, or use scale");
}

/// What a seed may change only of bodies.
void checkVariation(const Scenario& scenario, Reading& reading, const Node& root) {
  const VariationParameters& v = scenario.scene.variation;
  const auto refuse = [&](const char* path, const char* wrong, const char* right) {
    reading.problems.add(placeOf(root, path), path, wrong, right);
  };
  if (!scenario.scene.mechanics) {
    const std::pair<const char*, double> ofBodies[] = {{"variation.share", v.share},
                                                       {"variation.start", v.start},
                                                       {"variation.tilt", v.tilt},
                                                       {"variation.adhesion", v.adhesion}};
    for (const auto& [path, sd] : ofBodies)
      if (sd > 0) refuse(path, "cells without bodies have none", "add a physics block, or remove this");
    return;
  }
  const auto& contact = scenario.scene.mechanics->contact;
  if (v.adhesion > 0 && !(contact && contact->adhesion))
    refuse("variation.adhesion", "cells stick to each other only with physics.contact.adhesion",
           "give that, or remove this");
  const PhysicsParameters& physics = scenario.scene.mechanics->physics;
  if (!(v.start > 0) || !physics.shell || !scenario.scene.cells.empty()) return;
  const auto& axes = physics.shell->semiAxes;
  if (physics.cell.radius * reachOf(scenario) >= std::min({axes[0], axes[1], axes[2]}))
    refuse("variation.start", "the egg fills the shell, and can stand nowhere else",
           "remove this, or give a smaller physics.cell.radius");
}

/// Who says that an end need not be sane says why.
void checkReason(const CheckParameters& check, Reading& reading, const Node& root) {
  if (!check.sane && check.because.empty() && !given(root, "check.because"))
    reading.problems.add(placeOf(root, "check.sane"), "check.sane", "false without a reason",
                         "say why beside it: because: \"what the scene is about\"");
  if (check.sane && !check.because.empty())
    reading.problems.add(placeOf(root, "check.because"), "check.because",
                         "gives a reason for sane: false, and sane is true", "remove it, or write sane: false");
}

void checkBullet(const Scenario& scenario, Reading& reading, const Node& root) {
  if (!scenario.check.bullet) return;
  for (const Incompatibility& one : bulletIncompatibilities(scenario, scenario.check.bullet->baseline))
    reading.problems.add(placeOf(root, "check.bullet"), "check.bullet", one.wrong, one.right);
}

/// More would be neither stored nor looked at in any reasonable time.
void checkInterval(const std::string& path, std::optional<double> every, double most, const char* of,
                   const Scenario& scenario, Reading& reading, const Node& root) {
  const auto end = plannedEnd(scenario.scene);
  if (!every || !end || *end / *every <= most) return;
  reading.problems.add(placeOf(root, path), path,
                       exactText(*every) + " makes more than " + exactText(most) + " " + of +
                           " until the run's end at " + exactText(*end),
                       "needs at least " + exactText(*end / most) + " [time]");
}

/// What record.measures asks for must be there to be measured, and what check.reference gives must be asked for.
void checkMeasures(const Scenario& scenario, Reading& reading, const Node& root) {
  const auto& reference = scenario.check.reference;
  std::set<Needs> asked;
  for (const std::string& name : scenario.record.measures) {
    const AskedMeasure m = *findMeasure(name);
    asked.insert(m.needs);
    if (const std::string lacking = lackingFor(m.needs, scenario); !lacking.empty())
      reading.problems.add(placeOf(root, "record.measures"), "record.measures",
                           m.name + " would find nothing to measure", "needs " + lacking);
  }
  const RecordParameters& record = scenario.record;
  const auto isDuration = [](const std::string& name) { return name.starts_with("contact_duration"); };
  if (std::ranges::any_of(record.measures, isDuration) && !record.every && !record.meshes && record.atCells.empty() &&
      scenario.scene.cells.empty())
    reading.problems.add(placeOf(root, "record.measures"), "record.measures",
                         "contact_duration would always be 0: between the egg and the end there is no sample",
                         "needs record.every or record.at-cells");
  if (!reference) return;
  for (const auto& [needs, key, given, by] :
       {std::tuple(Needs::referenceContacts, "check.reference.contacts", !reference->contacts.empty(),
                   "contact_jaccard or contact_f1"),
        std::tuple(Needs::referencePositions, "check.reference.positions", !reference->positions.empty(),
                   "position_rmsd or position_shape_rmsd")})
    if (given && !asked.contains(needs))
      reading.problems.add(placeOf(root, key), key, "no measure compares with it",
                           std::string("name ") + by + " in record.measures, or remove it");
}

}  // namespace

void crossCheck(const Scenario& scenario, Reading& reading, const Node& root) {
  checkSubstances(scenario.scene.dna, reading);
  checkCellNames(scenario, reading, root);
  if (reading.problems.empty()) checkMeasures(scenario, reading, root);
  checkReason(scenario.check, reading, root);
  if (const auto& mechanics = scenario.scene.mechanics) {
    const bool isSphere = !kindOf(mechanics->physics.cell.model).hasMesh;
    const auto& shell = mechanics->physics.shell;
    if (shell && scenario.shellMesh && !shell->mesh) {
      // Why it could not be read has been said.
    } else if (shell && shell->mesh && scenario.scene.cells.empty()) checkMeshShell(scenario, reading, root);
    else if (scenario.eggIsStretched || (scenario.shellFill && scenario.scene.cells.empty() && !isSphere))
      checkFill(scenario, reading, root);
    else if (scenario.scene.cells.empty()) checkShell(scenario, reading, root);
    else checkStartCells(scenario, reading);
    checkEnergy(scenario, reading, root);
    checkCoarsening(scenario, reading, root);
    checkModel(scenario, reading, root);
    checkIntegrator(mechanics->physics, mechanics->contact && mechanics->contact->law != ContactLaw::thesis, reading,
                    root);
    checkSettling(scenario, reading, root);
    checkSpheres(scenario, reading, root);
    checkDivision(scenario, reading, root);
    checkConnections(scenario, reading, root);
    checkPlanes(scenario, reading, root);
    checkAdhesion(scenario, reading, root);
    checkMotility(mechanics->physics, reading, root);
    checkBullet(scenario, reading, root);
    checkDivisionSize(scenario, reading, root);
  }
  checkVariation(scenario, reading, root);
  checkSenses(scenario, reading, root);
  checkInterval("record.every", scenario.record.every, 1e7, "samples", scenario, reading, root);
  checkInterval("record.pictures", scenario.record.pictures, 1e5, "pictures", scenario, reading, root);
  checkInterval("record.meshes", scenario.record.meshes, 1e6, "samples of surfaces", scenario, reading, root);
  if (scenario.record.meshes && !scenario.scene.mechanics)
    reading.problems.add(placeOf(root, "record.meshes"), "record.meshes", "cells without bodies have no surfaces",
                         "add a physics block or remove this");
  if (scenario.record.pictures && !scenario.scene.mechanics)
    reading.problems.add(placeOf(root, "record.pictures"), "record.pictures", "cells without bodies cannot be drawn",
                         "add a physics block or remove this");
  if (const CheckParameters& c = scenario.check;
      !scenario.scene.mechanics && (c.volume || c.extent || c.energy || c.momentum || c.endVolume || c.endRoundness ||
                                    c.endOverlap || c.bullet || !c.sane))
    reading.problems.add(placeOf(root, "check"), "check", "cells without bodies have nothing to measure",
                         "add a physics block, or check only fails");
}

}  // namespace morula::scenario

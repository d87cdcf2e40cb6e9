// The resolved form, and the hash of a scenario's meaning.
#include <nlohmann/json.hpp>
#include <set>

#include "scenario/loading.h"
#include "state/scene_parts.h"
// Included last, because of CHECK:
#include "helpers.h"

using namespace morula;
using namespace morula::test;

namespace {

struct Hashes {
  Hash meaning;
  std::vector<std::string> parts;  // hashSceneParts
};
Hashes meaningAndParts(const Scenario& scenario) {
  Hashes hashes{scenario.meaning, {}};
  for (const ScenePart& part : hashSceneParts(scenario.scene)) hashes.parts.push_back(part.hash);
  return hashes;
}

}  // namespace

TEST_CASE("the resolved form is a scenario that means the same") {
  for (const auto& text : {everyPart, small + "physics: {}\n", replaced(small, "cells: 1", "time: 0.1")}) {
    const auto first = read(text);
    const auto second = read(first.resolved);
    CHECK(second.resolved == first.resolved);
    CHECK(second.meaning == first.meaning);
    CHECK(nlohmann::json::accept(first.resolved));
  }
}

TEST_CASE("comments, layout, spelling of numbers and key order mean nothing") {
  const auto meaning = read(everyPart).meaning;
  auto text = "# hello\n" + replaced(everyPart, "seed: 7\n", "");
  text = replaced(text, "drag: 0.25", "drag: 2.5e-1   # slow");
  text += "\n\nseed: +7\n";
  CHECK(read(text).meaning == meaning);
}

TEST_CASE("genes that a range writes mean what they mean written out") {
  const std::string around = "morula: 1\nname: x\nstop: {cycles: 3}\ndna: |\n  START: a0\n";
  const Scenario ranged = read(around + "  g{n}(a{n+1}|a{n}) for n in 0..1\n  d(divide|a2)\n");
  const Scenario plain = read(around + "  g0(a1|a0)\n  g1(a2|a1)\n  d(divide|a2)\n");
  CHECK(ranged.meaning == plain.meaning);
  CHECK(ranged.resolved == plain.resolved);
  CHECK(ranged.meaning != read(around + "  g{n}(a{n+1}|a{n}) for n in 0..2\n  d(divide|a2)\n").meaning);
}

TEST_CASE("names, colours and pictures mean nothing for the results") {
  const auto meaning = read(everyPart).meaning;
  CHECK(read(replaced(everyPart, "name: every-part", "name: other")).meaning == meaning);
  CHECK(read(replaced(everyPart, "egg: P0", "egg: Z")).meaning == meaning);
  CHECK(read(replaced(everyPart, "{A: AB}", "{A: AB, BB: Q}")).meaning == meaning);
  CHECK(read(replaced(everyPart, "[l, r]", "[a, p]")).meaning == meaning);
  CHECK(read(replaced(everyPart, "summary: All keys at once", "summary: x")).meaning == meaning);
  CHECK(read(replaced(everyPart, "#102030", "#102031")).meaning == meaning);
  CHECK(read(replaced(everyPart, "pictures: 0.5", "pictures: 0.25")).meaning == meaning);
  CHECK(read(replaced(everyPart, "[1, 0, 0], /B", "[1, 0, 4], /B")).meaning == meaning);
  CHECK(read(replaced(everyPart, "length: um, per-length: 27, time: min, per-time: 4", "time: h")).meaning == meaning);
  CHECK(read(replaced(everyPart, "extent: 9", "extent: 8")).meaning == meaning);
  CHECK(read(replaced(everyPart, "[springs, physics.time_step]", "[pressure]")).meaning == meaning);
  CHECK(read(replaced(everyPart, ", sane: false, because: it stops", "")).meaning == meaning);
}

TEST_CASE("every other parameter changes the meaning, and the checkpoint's scene if states go on otherwise") {
  const auto [meaning, parts] = meaningAndParts(read(everyPart));
  const std::vector<std::pair<std::string, std::string>> changes = {
      {"seed", "8"},
      {"dna", "START: a0, connect\ng1(a1|a0)\ng2(divide|a0)\ng3(a0|a1)"},
      {"cycle.length", "1"},
      {"cycle.per-substance", "{a0: 1}"},
      {"cycle.at-birth", "{a0: 1}"},
      {"cycle.at-birth", "{a1: 1.25}"},
      {"stop.cycles", "4"},
      {"stop.time", "9"},
      {"stop.cells", "5"},
      {"stop.when", "[{cells: 41}]"},
      {"stop.every", "0.25"},
      {"cells", "[{at: [1, 0, 0]}]"},
      {"cells", "[{at: [1, 0, 0]}, {at: [-1, 0, 0]}]"},
      {"cells", "[{at: [-1, 0, 0]}, {at: [1, 0, 0]}]"},
      {"cells", "[{at: [1, 0, 0], velocity: [1, 0, 0]}]"},
      {"cells", "[{at: [1, 0, 0], scale: 0.75}]"},
      {"cells", "[{at: [1, 0, 0], stretch: [0.75, 1, 1]}]"},
      {"cells", "[{at: [1, 0, 0], mass: 1}]"},
      {"cells", "[{at: [1, 0, 0], substances: [a0]}]"},
      {"cells", "[{at: [1, 0, 0], substances: []}]"},
      {"physics.time_step", "auto"},
      {"physics.integrator", "velocity-verlet"},
      {"physics.drag", "0.125"},
      {"physics.mesh.icosphere", "4"},
      {"physics.mesh.coarsen", "0.25"},
      {"physics.cell.radius", "0.25"},
      {"physics.cell.mass", "1"},
      {"physics.membrane.stiffness", "40"},
      {"physics.membrane.damping", "0.25"},
      {"physics.membrane.production", "1"},
      {"physics.membrane.bending", "0.25"},
      {"physics.membrane.springs", "equal"},
      {"physics.pressure.constant", "4"},
      {"physics.pressure.outside", "1"},
      {"physics.growth.rate", "0.1"},
      {"physics.growth.until", "1.25"},
      {"physics.shell.ellipsoid", "[3, 2, 1.5]"},
      {"physics.contact.law", "pair"},
      {"physics.contact.stiffness", "40"},
      {"physics.contact.damping", "0.2"},
      {"physics.contact.viscosity", "0.25"},
      {"physics.contact.slip-speed", "0.5"},
      {"physics.contact.radius", "1"},
      {"division.plane", "random"},
      {"division.plane", "{polarity: [0, 1, -1]}"},
      {"division.plane", "{polarity: {start: [0, 1, -1], turns-towards: a0}}"},
      {"division.plane", "{polarity: {start: [0, 1, -1], turns-away-from: a0}}"},
      {"division.plane", "{towards: a0}"},
      {"division.plane", "{towards: a*}"},
      {"division.plane", "{away-from: a0}"},
      {"division.chirality.angle", "-30"},
      {"division.chirality.time", "0.125"},
      {"division.rules", "[{of: a1, axis: [1, 0, 2], share: 0.4, tilt: 10}]"},
      {"division.rules", "[{of: 'a1*', axis: [1, 0, 2], share: 0.4, tilt: 10}]"},
      {"division.rules", "[{of: a1, axis: [1, 0, 1], share: 0.4, tilt: 10}]"},
      {"division.rules", "[{of: a1, plane: {alternating: [1, 0, 2]}, share: 0.4, tilt: 10}]"},
      {"division.rules", "[{of: a1, share: 0.4, tilt: 10}]"},
      {"division.rules", "[{of: a1, axis: [1, 0, 2], share: 0.5, tilt: 10}]"},
      {"division.rules", "[{of: a1, axis: [1, 0, 2], tilt: 10}]"},
      {"division.rules", "[{of: a1, axis: [1, 0, 2], share: 0.4, tilt: 0}]"},
      {"division.rules", "[{of: a1, axis: [1, 0, 2], share: 0.4}]"},
      {"division.rules", "[{of: a1, chirality: {angle: 30}}]"},
      {"division.rules", "[{of: a1, chirality: {angle: 30, time: 0.25}}]"},
      {"variation.cycle", "0"},
      {"variation.share", "0"},
      {"variation.start", "0"},
      {"variation.tilt", "0"},
      {"division.size", "timer"},
      {"division.size", "{sizer: 0.25}"},
      {"division.size", "{adder: 0.5}"},
      {"connections.release-age", "3"},
      {"experiments", "[{kill: path B, at: 1}]"},
      {"connections.most", "4"},
      {"connections.make", "both"},
      {"connections.on-division", "plane"},
      {"connections.strength", "0.5"},
      {"connections.release-distance", "2"},
      {"record.every", "0.5"},
      {"record.meshes", "0.5"},
      {"record.at-cells", "[2, 4]"},
      {"record.measures", "[position_rmsd, contact_f1]"},
      {"physics.shell.fill", "0.01"},
      {"physics.shell.holds", "vertices"},
  };
  std::vector<Hash> seen{meaning};
  std::set<std::string> tried;
  for (const auto& [path, value] : changes) {
    INFO(path << "=" << value);
    const auto [changed, changedParts] = meaningAndParts(read(everyPart, {{path, value, "--set " + path}}));
    CHECK(std::find(seen.begin(), seen.end(), changed) == seen.end());
    seen.push_back(changed);
    tried.insert(path);
    const bool decidesHowStatesGoOn =
        !path.starts_with("stop") && !path.starts_with("record") && path != "cells" && path != "variation.start";
    CHECK((changedParts != parts) == decidesHowStatesGoOn);
  }
  for (const auto& p : scenario::parameterTable().parameters) {
    INFO(p.path);
    const bool isTriedElsewhere = std::set<std::string>{"morula",
                                                        "cycle.first",  // experiments.cpp
                                                        "physics.mesh.file",
                                                        "physics.substeps",
                                                        "physics.precision",
                                                        "physics.cell.model",
                                                        "physics.shell.sphere",
                                                        "physics.shell.mesh",        // mesh_shell.cpp
                                                        "physics.contact.adhesion",  // tissues.cpp
                                                        "connections.release-tension",
                                                        "variation.adhesion"}
                                      .contains(p.path) ||
                                  p.path.starts_with("physics.shape-matching") ||
                                  p.path.starts_with("physics.motility") ||
                                  p.path.starts_with("physics.quasi-static") ||
                                  p.path.starts_with("connections.spring");
    if (p.decides == scenario::Decides::results && !isTriedElsewhere) CHECK(tried.contains(p.path));
  }
}

TEST_CASE("so do those of other cell models, other integrators and single precision") {
  const std::string text =
      "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics: {shell: {sphere: 3},\n"
      "  INTEGRATOR cell: {mass: 2, model: MODEL}}\n";
  const auto of = [&](const std::string& model, const std::string& integrator, const Override& change) {
    return meaningAndParts(read(replaced(replaced(text, "MODEL", model), "INTEGRATOR", integrator), {change}));
  };
  const auto differ = [&](const std::string& model, const std::string& integrator, const std::string& path,
                          const std::string& value, const std::string& other) {
    INFO(path);
    const auto [a, partsA] = of(model, integrator, {path, value, "--set"});
    const auto [b, partsB] = of(model, integrator, {path, other, "--set"});
    CHECK(a != b);
    CHECK(partsA != partsB);
  };
  differ("shell", "", "physics.cell.model", "shell", "sphere");
  differ("shell", "", "physics.precision", "double", "single");
  differ("shell", "", "physics.shell.sphere", "3", "4");
  differ("shell", "time_step: 0.5, integrator: xpbd,", "physics.substeps", "2", "3");
  differ("shell", "integrator: quasi-static,", "physics.quasi-static.evaluations", "20", "40");
  differ("shell", "integrator: quasi-static,", "physics.quasi-static.drag", "2", "4");
  differ("shell", "integrator: quasi-static,", "physics.quasi-static.together", "0.1", "0.2");
  differ("shell", "integrator: quasi-static,", "physics.quasi-static.residual", "0.01", "0.001");
  differ("shape-matching", "", "physics.shape-matching.stiffness", "300", "400");
  differ("shape-matching", "", "physics.shape-matching.linear", "0.25", "0.5");
  differ("shape-matching", "", "physics.shape-matching.damping", "3", "4");
}

TEST_CASE("what joined the format later means nothing at its default, and something else otherwise") {
  const std::string text = "morula: 1\nname: x\ndna: 'START: a0'\nstop: {time: 1}\nphysics: {cell: {mass: 2}}\n";
  // Goldens hold such hashes. This one changes only with a default, or with a radius's meaning for the mesh.
  CHECK(read(text).meaning.text() == "bee11b913353793bf0a4a0b8c455d887");
  CHECK(read(replaced(text, "{mass: 2}", "{mass: 2, model: shell}")).meaning == read(text).meaning);
  CHECK(read(replaced(text, "{mass: 2}", "{mass: 2, model: sphere}")).meaning != read(text).meaning);
}

TEST_CASE("the same number means another thing elsewhere") {
  CHECK(read(small).meaning != read(replaced(small, "cells", "cycles")).meaning);
}

TEST_CASE("a sphere is an ellipsoid with equal axes") {
  const auto sphere = read(replaced(everyPart, "{ellipsoid: [3, 2, 1], fill", "{sphere: 2, fill"));
  const auto ellipsoid = read(replaced(everyPart, "[3, 2, 1]", "[2, 2.0, 2e0]"));
  CHECK(sphere.meaning == ellipsoid.meaning);
}

TEST_CASE("what cells are not made of is not resolved") {
  const std::string shells = "morula: 1\nname: x\ndna: 'START: a0'\nstop: {cycles: 3}\nphysics: {cell: {mass: 1}}\n";
  const auto usual = read(shells);
  CHECK(read(replaced(shells, "mass: 1", "mass: 1, model: shell")).meaning == usual.meaning);
  CHECK(usual.resolved.find("shape-matching") == std::string::npos);

  const std::string shapes = replaced(shells, "mass: 1", "mass: 1, model: shape-matching");
  const auto matched = read(shapes);
  CHECK(matched.resolved.find("membrane") == std::string::npos);
  CHECK(matched.resolved.find("pressure") == std::string::npos);
  CHECK(read(matched.resolved).meaning == matched.meaning);
  CHECK(matched.meaning != usual.meaning);
}

TEST_CASE("sub-steps change the meaning, and one of another integrator is all that it takes") {
  const std::string text =
      "morula: 1\nname: x\ndna: 'START: a0'\nstop: {cycles: 3}\nphysics: {time_step: 0.01, integrator: xpbd}\n";
  CHECK(read(replaced(text, "xpbd", "xpbd, substeps: 3")).meaning != read(text).meaning);
  CHECK(complaints(replaced(text, "xpbd", "rk4, substeps: 1")) == "");
  CHECK_FALSE(complaints(replaced(text, "xpbd", "rk4, substeps: 2")) == "");
}

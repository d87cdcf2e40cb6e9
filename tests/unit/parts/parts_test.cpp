// The parts reported as engaged are the parts that the world has.
#include "parts/parts.h"

#include <map>
#include <set>

#include "contacts/contacts.h"
#include "loop/simulate.h"
#include "simulation/simulation.h"
#include "unit/scenario/helpers.h"

using namespace morula;
using morula::test::read;

namespace {

std::map<std::string, Part> byName(const Scenario& scenario, const RunAsk& ask = {}) {
  std::map<std::string, Part> all;
  for (const Part& part : partsOf(scenario, ask)) {
    CHECK_FALSE(all.contains(part.name));
    CHECK_FALSE(part.why.empty());
    all[part.name] = part;
  }
  return all;
}

std::set<std::string> engagedIn(const std::map<std::string, Part>& parts) {
  std::set<std::string> names;
  for (const auto& [name, part] : parts)
    if (part.engaged) names.insert(name);
  return names;
}

const std::string genes =
    "morula: 1\nname: some\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 2}\n";

/// Returns a scene with the parts that the bits of `choice` select.
std::string sceneOf(unsigned choice) {
  std::string text = genes + "physics:\n  mesh: {icosphere: 0}\n";
  text += choice & 1 ? "  drag: 2\n" : "";
  text += choice & 2 ? "  membrane: {damping: 0.03}\n" : "  membrane: {damping: 0}\n";
  text += choice & 4 ? (choice & 2 ? "  shell: {sphere: 1}\n" : "  shell: {ellipsoid: [2, 1.5, 1]}\n") : "";
  text += choice & 8 ? (choice & 16 ? "  contact: {viscosity: 0.3}\n" : "  contact: {}\n") : "";
  text += choice & 32 ? "  growth: {}\n" : "";
  text += choice & 64 ? "connections: {}\n" : "";
  return text;
}

}  // namespace

TEST_CASE("For every choice of blocks: the parts that are told are those that makeWorld makes") {
  std::set<std::set<std::string>> different;
  for (unsigned choice = 0; choice < 128; ++choice) {
    if (!(choice & 8) && choice & 16) continue;
    INFO(sceneOf(choice));
    const Scenario scenario = read(sceneOf(choice));
    const World world = makeWorld(scenario.scene);
    const PhysicsKernels& kernels = physicsKernels(world.execution.isa);
    auto parts = byName(scenario);
    CHECK(parts["bodies"].engaged == world.bodies.has_value());
    CHECK(parts["springs"].engaged);
    CHECK(parts["pressure"].engaged);
    CHECK(parts["integration"].engaged);
    CHECK(parts["damping"].engaged == (world.stages.findTensions == kernels.findWeightedTensions[true]));
    CHECK(parts["drag"].engaged == (world.stages.finishForces == kernels.addPressureAndDragForces));
    CHECK(parts["shell"].engaged == (world.stages.kick != kernels.kickVelocityVerlet[false]));
    CHECK(parts["shell"].what == (choice & 4 ? choice & 2 ? "sphere" : "ellipsoid" : ""));
    CHECK(parts["contact"].engaged == world.contacts.has_value());
    CHECK(parts["search"].engaged == world.contacts.has_value());
    CHECK(parts["viscosity"].engaged ==
          (world.contacts && world.contacts->addForces == world.contacts->kernels->addPairForcesWithViscosity));
    CHECK(parts["connections"].engaged == world.connections.has_value());
    CHECK(parts["growth"].engaged == world.model.mechanics->physics.growth.has_value());
    CHECK(parts["division"].engaged == (world.divisionPolicy != nullptr));
    different.insert(engagedIn(parts));
  }
  CHECK(different.size() == 96);
}

TEST_CASE("Cells by shape matching have no springs and no pressure, and walk rings for contacts only") {
  for (const bool touch : {false, true})
    for (const bool resisted : {false, true}) {
      const Scenario scenario =
          read(genes + "physics:\n  mesh: {icosphere: 0}\n  cell: {model: shape-matching}\n" +
               (resisted ? "" : "  shape-matching: {damping: 0}\n") + (touch ? "  contact: {}\n" : ""));
      const World world = makeWorld(scenario.scene);
      const PhysicsKernels& kernels = physicsKernels(world.execution.isa);
      auto parts = byName(scenario);
      CHECK(parts["shape-matching"].engaged);
      for (const char* name : {"springs", "damping", "pressure"}) CHECK_FALSE(parts[name].engaged);
      CHECK(world.stages.finishForces == kernels.findShapeForces[resisted][!touch]);
      CHECK((world.stages.accumulateRings == kernels.accumulateAreaVectors) == touch);
    }
  CHECK_FALSE(byName(read(sceneOf(0)))["shape-matching"].engaged);
}

TEST_CASE("Without physics there are genes, and nothing that needs a body") {
  const Scenario scenario = read(genes);
  const World world = makeWorld(scenario.scene);
  REQUIRE_FALSE(world.bodies);
  CHECK(engagedIn(byName(scenario, {.pictures = false})) ==
        std::set<std::string>{"biology", "samples"});  // at the start and at the end
}

TEST_CASE("Each part names the line that asks for it, or says that it is a default") {
  auto parts = byName(read(test::everyPart));
  CHECK(parts["biology"].why == "test.yaml:5:6: dna");
  CHECK(parts["drag"].why == "test.yaml:18:9: physics.drag");
  CHECK(parts["shell"].why == "test.yaml:24:10: physics.shell");
  CHECK(parts["contact"].why == "test.yaml:25:18: physics.contact.law");
  CHECK(parts["contact"].what == "the thesis' law");
  CHECK_FALSE(parts["viscosity"].engaged);  // the thesis' law has no viscosity, whatever its number
  CHECK(parts["connections"].why == "test.yaml:31:14: connections");
  CHECK(parts["samples"].why == "test.yaml:34:17: record.every");
  CHECK(parts["hashes"].why == "test.yaml:37:8: check");
  parts = byName(read(sceneOf(8), {{"physics.drag", "2", "--set physics.drag"}}));
  CHECK(parts["drag"].why == "--set physics.drag");
  CHECK(parts["springs"].why == "default");
  CHECK(parts["viscosity"].why == "physics.contact.viscosity > 0");
  CHECK(byName(read(sceneOf(8)), {.search = ContactSearch::aabbTree})["search"].why == "--search");
}

TEST_CASE("Bodies tell their meshes and their precision") {
  const std::string text = genes + "physics:\n  mesh: {icosphere: 3, coarsen: 0.3}\n  precision: single\n";
  CHECK(byName(read(text))["bodies"].what == "642 vertices each, fewer when small, in single precision");
  CHECK(byName(read(sceneOf(0)))["bodies"].what == "12 vertices each");
}

TEST_CASE("States are hashed on the way only where somebody looks at them") {
  const Scenario plain = read(sceneOf(0)), checked = read(sceneOf(0) + "check: {}\n");
  CHECK_FALSE(wantsHashes(plain, false));
  CHECK(wantsHashes(plain, true));
  CHECK(wantsHashes(checked, false));
  CHECK(byName(plain, {.golden = "some.golden"})["hashes"].why == "golden file some.golden");
  CHECK_FALSE(byName(plain)["golden"].engaged);
  CHECK_FALSE(byName(plain, {.pictures = false})["pictures"].engaged);
}

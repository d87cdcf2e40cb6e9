// Experiments: the run equals the wild type to the bit until the experiment, and then what was named happens.
#include <cmath>
#include <functional>
#include <map>
#include <utility>

#include "catch.h"
#include "connecting.h"
#include "scenes.h"
#include "simulation/make_world.h"
#include "simulation/restore.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

CellSelection cellOfPath(const char* path) {
  return {.kind = CellSelection::Kind::cell, .path = CellPath::parse(path)};
}
CellSelection cloneOfPath(const char* path) {
  return {.kind = CellSelection::Kind::clone, .path = CellPath::parse(path)};
}

Scene withExperiments(Scene scene, std::vector<Experiment> experiments) {
  scene.experiments = std::move(experiments);
  return scene;
}

/// The state without what was done, which the wild type does not have.
std::vector<CellHash> cellHashes(const World& world) { return hashState(world).cells; }

World runWorldTo(const Scene& scene, double time, const Execution& how = {Isa::scalar, 1}) {
  World world = makeWorld(scene, how);
  while (!finished(world) && world.clock.time < time) step(world);
  return world;
}

}  // namespace

TEST_CASE("A cell that is killed dies then and alone, and everything before is the wild type's to the bit") {
  const Scene wild = scenes::packed();
  World before = makeWorld(wild, {Isa::scalar, 1});
  World ablated =
      makeWorld(withExperiments(wild, {{.deed = Deed::kill, .of = {cellOfPath("AA")}, .at = 2.3}}), {Isa::scalar, 1});
  while (before.clock.time < 2.3) {
    CHECK(cellHashes(before) == cellHashes(ablated));
    step(before), step(ablated);
  }
  REQUIRE(ablated.clock.time == before.clock.time);
  CHECK(pathsOf(before) == std::vector<std::string>{"AA", "AB", "BA", "BB"});
  CHECK(pathsOf(ablated) == std::vector<std::string>{"AB", "BA", "BB"});
  const auto& done = *ablated.experiments;
  REQUIRE(done.size() == 1);
  CHECK(done[0].path == CellPath::parse("AA"));
  CHECK(done[0].time == ablated.clock.time);
  const LineageEntry& entry = *std::ranges::find(ablated.lineage.entries, CellPath::parse("AA"), &LineageEntry::path);
  CHECK(entry.fate == Fate::died);
  CHECK(entry.ended == ablated.clock.time);
}

TEST_CASE("Without bodies an experiment takes place at its very time, between cell cycles") {
  const Scene wild = scenes::lineageOnly(scenes::everybodyDivides, 4);
  const World world = runWorldTo(withExperiments(wild, {{.deed = Deed::kill, .of = {cellOfPath("A")}, .at = 1.25}}), 9);
  const LineageEntry& a = *std::ranges::find(world.lineage.entries, CellPath::parse("A"), &LineageEntry::path);
  CHECK(a.fate == Fate::died);
  CHECK(a.ended == 1.25);
  CHECK(world.cells.path.size() == 8);  // of B alone
}

TEST_CASE("A clone, a generation, a share and cells after their birth: those that are named, and no others") {
  const Scene wild = scenes::lineageOnly(scenes::everybodyDivides, 4);
  const auto living = [&](const Experiment& e) { return pathsOf(runWorldTo(withExperiments(wild, {e}), 9)); };
  for (const std::string& path : living({.deed = Deed::kill, .of = {cloneOfPath("AB")}, .at = 3.5}))
    CHECK(path.substr(0, 2) != "AB");
  CHECK(living({.deed = Deed::kill, .of = {cloneOfPath("AB")}, .at = 3.5}).size() == 12);
  CHECK(living({.deed = Deed::kill, .of = {{.kind = CellSelection::Kind::generation, .generation = 2}}, .at = 2.5})
            .empty());
  // Each of the two of the first generation dies half a cycle after her birth, and nothing is left.
  CHECK(living(
            {.deed = Deed::kill, .of = {{.kind = CellSelection::Kind::generation, .generation = 1}}, .afterBirth = 0.5})
            .empty());
  const std::size_t left = living({.deed = Deed::kill, .share = 0.5, .atCells = 16}).size();
  CHECK(left > 2);
  CHECK(left < 14);
}

TEST_CASE("A gene that is off from the start gives the scene without it; on again, it acts again") {
  const std::string dna = scenes::uniqueFour;
  std::string without = dna;
  without.replace(without.find("g5(divide|a1)\n"), 14, "");
  const auto tree = [](const World& world) {
    std::vector<std::pair<std::string, double>> cells;
    for (const LineageEntry& e : world.lineage.entries) cells.emplace_back(e.path.text(), e.ended);
    return cells;
  };
  const Scene scene = scenes::lineageOnly(dna, 5);
  const World off = runWorldTo(withExperiments(scene, {{.deed = Deed::geneOff, .name = "g5", .at = 0}}), 9);
  CHECK(tree(off) == tree(runWorldTo(scenes::lineageOnly(without, 5), 9)));
  const World again = runWorldTo(withExperiments(scene, {{.deed = Deed::geneOff, .name = "g5", .at = 0},
                                                         {.deed = Deed::geneOn, .name = "g5", .at = 0.5}}),
                                 9);
  CHECK(tree(again) == tree(runWorldTo(scene, 9)));
}

TEST_CASE("A parameter that is set slows a cell as its closed form says") {
  // Only drag acts on a cell in flight: its speed falls as exp(-drag t).
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene.mechanics->physics.drag = 1;
  scene.mechanics->physics.timeStep = 0x1p-9;
  scene.cells = {{.at = {0, 0, 0}, .velocity = {1, 0, 0}}};
  const Experiment faster{.deed = Deed::set, .name = "physics.drag", .value = 4, .at = 0.25};
  const auto speedAt = [&](double time) {
    const World world = runWorldTo(withExperiments(scene, {faster}), time);
    const Bodies& b = *world.bodies;
    double sum = 0;
    for (int v = 0; v < b.vertexCount(b.slots[0]); ++v) sum += b.read(b.velocity, b.slots[0], v).x;
    return sum / b.vertexCount(b.slots[0]);
  };
  // Velocity Verlet with drag errs by (drag dt)² a step, 4e-5 here over all of them.
  CHECK(speedAt(0.25) == Approx(std::exp(-0.25)).epsilon(1e-3));
  CHECK(speedAt(0.75) == Approx(std::exp(-0.25 - 4 * 0.5)).epsilon(1e-2));
}

TEST_CASE("Each parameter that is set gives the forces of a scene that has it from the start") {
  Scene scene = scenes::packed();
  scene.mechanics->physics.drag = 0.5;
  scene.mechanics->physics.growth = GrowthParameters{.rate = 0.1};
  scene.mechanics->contact->adhesion = AdhesionParameters{.strength = 0.5, .pairs = {}};
  const std::map<std::string, std::function<void(MechanicsScene&, double)>> setters{
      {"physics.drag", [](auto& m, double x) { m.physics.drag = x; }},
      {"physics.membrane.stiffness", [](auto& m, double x) { m.physics.membrane.stiffness = x; }},
      {"physics.membrane.damping", [](auto& m, double x) { m.physics.membrane.damping = x; }},
      {"physics.membrane.damping.ratio", [](auto& m, double x) { m.physics.membrane.damping.ratio = x; }},
      {"physics.contact.damping.ratio", [](auto& m, double x) { m.contact->damping.ratio = x; }},
      {"physics.pressure.outside", [](auto& m, double x) { m.physics.pressure.outside = x; }},
      {"physics.growth.rate", [](auto& m, double x) { m.physics.growth->rate = x; }},
      {"physics.contact.stiffness", [](auto& m, double x) { m.contact->stiffness = x; }},
      {"physics.contact.damping", [](auto& m, double x) { m.contact->damping = x; }},
      {"physics.contact.adhesion.strength", [](auto& m, double x) { m.contact->adhesion->strength = x; }}};
  REQUIRE(setters.size() == changeableParameters.size());
  const auto accelerations = [](const World& world) {
    std::vector<double> all;
    for (const int slot : world.bodies->slots)
      for (int v = 0; v < world.bodies->vertexCount(slot); ++v) {
        const Vector a = world.bodies->read(world.bodies->acceleration, slot, v);
        all.insert(all.end(), {a.x, a.y, a.z});
      }
    return all;
  };
  for (const auto& [name, set] : setters) {
    CAPTURE(name);
    // A ratio can be set where the scene has one.
    scene.mechanics->physics.membrane.damping.ratio = name == "physics.membrane.damping.ratio" ? 0.1 : 0;
    scene.mechanics->contact->damping.ratio = name == "physics.contact.damping.ratio" ? 0.1 : 0;
    const World wild = runWorldTo(scene, 2.5);
    constexpr double value = 0.75;
    World changed =
        runWorldTo(withExperiments(scene, {{.deed = Deed::set, .name = name, .value = value, .at = wild.clock.time}}),
                   wild.clock.time);
    REQUIRE(changed.clock.time == wild.clock.time);
    Scene other = scene;
    set(*other.mechanics, value);
    World expected = makeWorld(other, {Isa::scalar, 1});
    expected.clock = wild.clock, expected.cells = wild.cells, expected.lineage = wild.lineage;
    const Bodies fresh = std::exchange(*expected.bodies, *wild.bodies);
    expected.bodies->parameters = fresh.parameters, expected.bodies->kernelParameters = fresh.kernelParameters;
    beginWithBodies(expected);
    CHECK(accelerations(changed) == accelerations(expected));
    if (name != "physics.growth.rate") CHECK(accelerations(changed) != accelerations(wild));
    CHECK(changed.bodies->parameters.growth->rate == expected.bodies->parameters.growth->rate);
  }
}

TEST_CASE("Cycles that are scaled and cells that are delayed divide when they should") {
  const Scene wild = scenes::lineageOnly(scenes::everybodyDivides, 3);
  const auto ended = [&](const Experiment& e, const char* path) {
    const World world = runWorldTo(withExperiments(wild, {e}), 9);
    return std::ranges::find(world.lineage.entries, CellPath::parse(path), &LineageEntry::path)->ended;
  };
  CHECK(ended({.deed = Deed::cycles, .of = {cloneOfPath("A")}, .value = 1.25, .at = 0}, "A") == 2.25);
  CHECK(ended({.deed = Deed::cycles, .of = {cloneOfPath("A")}, .value = 1.25, .at = 0}, "B") == 2);
  CHECK(ended({.deed = Deed::delay, .of = {cellOfPath("B")}, .value = 0.5, .at = 1.5}, "B") == 2.5);
  CHECK(ended({.deed = Deed::delay, .of = {cellOfPath("B")}, .value = 0.5, .at = 1.5}, "A") == 2);
  // A cycle that is over by the new length ends now.
  CHECK(ended({.deed = Deed::cycles, .of = {cellOfPath("A")}, .value = 0.25, .at = 1.75}, "A") == 1.75);
}

TEST_CASE("Cells are connected and released by hand") {
  Scene scene = scenes::packed();
  scene.mechanics->connections = ConnectionParameters{MakeConnections::byGene, ConnectionsOnDivision::plane, 0.2, {}};
  const World world = runWorldTo(
      withExperiments(scene, {{.deed = Deed::connect, .of = {cellOfPath("AA"), cellOfPath("BB")}, .at = 2.2},
                              {.deed = Deed::release, .of = {cellOfPath("AA"), cellOfPath("BB")}, .at = 2.5}}),
      2.6);
  REQUIRE(world.connections->history.size() == 1);
  const ConnectionRecord& record = world.connections->history[0];
  CHECK(record.made >= 2.2);
  CHECK(record.released >= 2.5);
  CHECK(record.cause == ReleaseCause::experiment);
}

TEST_CASE("An experiment that finds no cell ends the run, and the text says when the cell lived") {
  const Scene scene = withExperiments(scenes::lineageOnly(scenes::everybodyDivides, 4),
                                      {{.deed = Deed::kill, .of = {cellOfPath("A")}, .at = 2.5}});
  CHECK_THROWS_WITH(runWorldTo(scene, 9),
                    ContainsSubstring("experiments[0].kill at time 2.5: cell A does not live then; cell "
                                      "A lived from 1 to 2"));
}

TEST_CASE("What was done survives a checkpoint, and no thread or instruction set changes a bit") {
  Scene scene = scenes::life();
  const std::vector<Experiment> all{{.deed = Deed::geneOff, .name = "g18", .at = 1.1},
                                    {.deed = Deed::set, .name = "physics.drag", .value = 2, .at = 1.4},
                                    {.deed = Deed::cycles, .of = {cloneOfPath("A")}, .value = 1.1, .at = 1.5},
                                    {.deed = Deed::delay, .value = 0.3, .share = 0.5, .at = 2.2},
                                    {.deed = Deed::kill, .of = {cellOfPath("BA")}, .at = 2.4}};
  scene = withExperiments(scene, all);
  const auto end = [&](const Execution& how) { return hashState(runWorldTo(scene, 3.5, how)).whole; };
  const Hash expected = end({Isa::scalar, 1});
  CHECK(end({bestIsa(), 2}) == expected);
  for (const double time : {1.0, 1.3, 1.45, 1.8, 2.3, 2.6}) {
    CAPTURE(time);
    const std::string saved = saveState(runWorldTo(scene, time));
    World world = makeWorld(scene, {bestIsa(), 1});
    restoreState(world, saved);
    while (!finished(world) && world.clock.time < 3.5) step(world);
    CHECK(hashState(world).whole == expected);
  }
}

TEST_CASE("Isolated cells that make many steps at once stop at an experiment") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene = withExperiments(scene, {{.deed = Deed::kill, .of = {cellOfPath("A")}, .at = 1.3}});
  World one = makeWorld(scene, {Isa::scalar, 1}), many = makeWorld(scene, {Isa::scalar, 1});
  while (!finished(one)) step(one);
  while (!finished(many)) takeSteps(many, 64);
  CHECK(hashState(one).whole == hashState(many).whole);
}

// Quantities that a seed varies: cycles, shares and the start; and unequal divisions of whole worlds.

#include "base/random.h"
#include "catch.h"
#include "simulation/restore.h"
#include "simulation/start_variation.h"
#include "worlds.h"

using namespace morula;

namespace {

double deviate(const Scene& scene, const CellPath& path, Purpose purpose, std::uint32_t number = 0) {
  return randomDeviate({scene.seed, path, 0, purpose}, number);
}

Scene varied(double cycle, std::uint64_t seed = 3) {
  Scene s = scenes::lineageOnly(scenes::everybodyDivides, 5);
  s.variation.cycle = cycle;
  s.seed = seed;
  return s;
}

/// [radii] Returns the deviate by which a first cell stands off its place.
Vector startDeviate(const Scene& scene, const CellPath& path) {
  return {deviate(scene, path, Purpose::startVariation, 0), deviate(scene, path, Purpose::startVariation, 1),
          deviate(scene, path, Purpose::startVariation, 2)};
}

}  // namespace

TEST_CASE("Each cell has a pace of its own, and divides when the cycles of its line add up to it") {
  const Scene scene = varied(0.1);
  const World world = ranToEnd(scene);
  int compared = 0;
  for (const LineageEntry& e : world.lineage.entries) {
    double due = 0;
    for (CellPath path = e.path; !path.isEgg(); ++compared) {
      path = path.mother();
      due += 1 + 0.1 * deviate(scene, path, Purpose::cycleVariation);
    }
    CHECK(e.born == Approx(due).epsilon(1e-13));
  }
  CHECK(compared > 80);
}

TEST_CASE("A pace is for life: a cell that does not divide keeps it") {
  Scene scene = varied(0.2);
  scene.dna = parseDna("START: a0\ng1(a1|a0)\ng2(a0|a1)\ng3(divide|a0)\n", "test.dna");  // divides every other cycle
  const World world = ranToEnd(scene);
  const auto births = birthsOf(world);
  const double egg = 1 + 0.2 * deviate(scene, {}, Purpose::cycleVariation);
  const double first = 1 + 0.2 * deviate(scene, CellPath::parse("A"), Purpose::cycleVariation);
  CHECK(births.at("A") == Approx(egg));
  CHECK(births.at("AA") == Approx(egg + 2 * first));
}

TEST_CASE("Substances' own lengths vary as cycle.length does") {
  Scene scene = varied(0.1);
  scene.cycle.perSubstance = {{"a0", 0.25}};
  scene.stop.cycles = 1;
  const World world = ranToEnd(scene);
  CHECK(birthsOf(world).at("A") ==
        Approx(0.25 * (1 + 0.1 * deviate(scene, {}, Purpose::cycleVariation))).epsilon(1e-14));
}

TEST_CASE("Bodies leave the lineage as it is, and the plane leaves the paces as they are") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene.variation = {.cycle = 0.15, .share = 0.04, .start = 0.1, .tilt = 8};
  Scene other = scene;
  other.mechanics->division.otherwise = {DivisionPlane::axis, {1, 2, 2}};
  Scene lineage = scene;
  lineage.mechanics.reset();
  const World a = ranToEnd(scene), b = ranToEnd(other), c = ranToEnd(lineage);
  CHECK(birthsOf(a) == birthsOf(b));
  const auto bodies = birthsOf(a), none = birthsOf(c);
  REQUIRE(bodies.size() == none.size());
  for (const auto& [path, born] : none) {
    CAPTURE(path);
    CHECK(bodies.at(path) >= born * (1 - 1e-12));
    CHECK(bodies.at(path) <= born + a.timeSteps.front().timeStep + 1e-12);  // the first step after the cycle
  }
  // Shares deviate from a half by the same deviate under both planes.
  REQUIRE(a.divisions.size() == b.divisions.size());
  for (std::size_t i = 0; i < a.divisions.size(); ++i) {
    CHECK(a.divisions[i].path == b.divisions[i].path);
    CHECK(a.divisions[i].share ==
          Approx(0.5 + 0.04 * deviate(scene, a.divisions[i].path, Purpose::shareVariation)).margin(5e-3));
  }
}

TEST_CASE("Automatic time steps are no longer than the shortest cycle that variation can bring") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.cycle.length = 0.01;
  const double plain = makeWorld(scene).clock.timeStep;
  CHECK(plain == 0x1p-7);
  scene.variation.cycle = 0.25;  // the shortest cycle is 0.25 of the mean
  CHECK(makeWorld(scene).clock.timeStep == 0x1p-9);
  scene.mechanics->physics.timeStep = 0x1p-7;
  CHECK_THROWS_WITH(makeWorld(scene), ContainsSubstring("less variation.cycle"));
}

TEST_CASE("A first cell stands off its place by a deviate along each axis") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.variation.start = 0.1;
  const double radius = scene.mechanics->physics.cell.radius;
  const Point egg = centreOf(makeWorld(scene), "");
  CHECK(norm(egg - 0.1 * radius * startDeviate(scene, {})) < 1e-14);

  scene.cells = {{.at = {-2, 0, 0}}, {.at = {2, 0, 0}, .scale = 0.5}};
  const World two = makeWorld(scene);
  for (const auto& [path, at] : {std::pair("A", Point{-2, 0, 0}), std::pair("B", Point{2, 0, 0})})
    CHECK(norm(centreOf(two, path) - at - 0.1 * radius * startDeviate(scene, CellPath::parse(path))) < 1e-14);
}

TEST_CASE("No first cell leaves the shell, and one that would stands against it") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  scene.mechanics->physics.shell = ShellParameters{{1.5, 1.2, 1}};
  scene.variation.start = 0.3;
  int against = 0;
  for (scene.seed = 0; scene.seed < 50; ++scene.seed) {
    const std::vector<CellPath> paths{CellPath{}};
    const StartCell cell = placeStart(scene, paths).at(0);
    const double outermost = outermostSquare(cell, scene.mechanics->mesh, *scene.mechanics->physics.shell);
    CHECK(outermost <= 1);
    against += outermost > 1 - 1e-9;
  }
  CHECK(against > 5);
  CHECK(against < 50);
}

TEST_CASE("Rules share out volumes, of meshes as of spheres, and the record says how") {
  for (const bool spheres : {false, true}) {
    CAPTURE(spheres);
    Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
    if (spheres) {
      scene.mechanics->physics.cell.model = CellModel::sphere;
      scene.mechanics->physics.drag = 20;
      scene.mechanics->contact = scenes::pairContact;
    }
    scene.mechanics->division.otherwise = {DivisionPlane::axis, {0, 1, 0}};
    scene.mechanics->division.rules = {
        {.of = {"a1"}, .plane = {{DivisionPlane::axis, {0, 0, -1}}}, .share = 0.7, .tilt = 4.0}};
    const double whole = makeWorld(scene).bodies->mass(0);
    World world = makeWorld(scene);
    while (world.divisions.empty()) step(world);
    const DivisionRecord& egg = world.divisions.front();
    CHECK(egg.share == Approx(0.7).epsilon(1e-9));
    CHECK(dot(egg.axis, {0, 0, -1}) > 0.8);
    CHECK(dot(egg.axis, {0, 0, -1}) < 1);
    const int a = world.bodies->slots[cellNumber(world.cells, CellPath::parse("A"))];
    CHECK(world.bodies->mass(a) == Approx(0.7 * whole).epsilon(1e-9));
    CHECK(centreOf(world, "A").z < centreOf(world, "B").z);
  }
}

TEST_CASE("A state that was saved between two divisions goes on with the same deviations") {
  World whole = makeWorld(scenes::varied(), {Isa::scalar, 1}), part = makeWorld(scenes::varied(), {Isa::scalar, 1});
  while (part.divisions.empty()) step(part);
  World resumed = makeWorld(scenes::varied(), {Isa::scalar, 1});
  restoreState(resumed, saveState(part));
  runToEnd(whole), runToEnd(resumed);
  CHECK(whole.divisions.size() == 3);
  CHECK(whole.divisions == resumed.divisions);
  CHECK(stateHash(whole) == stateHash(resumed));
}

TEST_CASE("A scene turned about turns its divisions: shares, paces and angles of tilts stay") {
  // Turns by a third about (1, 1, 1), which rounds nothing: (x, y, z) → (z, x, y).
  const auto turn = [](const Vector& a) { return Vector{a.z, a.x, a.y}; };
  Scene scene = scenes::varied();
  scene.variation.start = 0;
  scene.mechanics->physics.shell.reset();
  scene.mechanics->division.rules.resize(1);
  scene.mechanics->division.otherwise = {DivisionPlane::axis, {0, 1, 0}};
  Scene turned = scene;
  for (Point& x : turned.mechanics->mesh.vertices) x = turn(x);
  turned.mechanics->division.rules[0].plane->axis = turn({-1, 0, 0.5});
  turned.mechanics->division.otherwise.axis = turn({0, 1, 0});
  const World a = ranToEnd(scene), b = ranToEnd(turned);
  REQUIRE(a.divisions.size() == b.divisions.size());
  const Vector axes[] = {Vector{-1, 0, 0.5} / norm({-1, 0, 0.5}), {0, 1, 0}, {0, 1, 0}};
  for (std::size_t i = 0; i < a.divisions.size(); ++i) {
    CAPTURE(i);
    CHECK(a.divisions[i].time == b.divisions[i].time);
    CHECK(a.divisions[i].share == Approx(b.divisions[i].share).epsilon(1e-14));
    CHECK(dot(a.divisions[i].axis, axes[i]) == Approx(dot(b.divisions[i].axis, turn(axes[i]))).epsilon(1e-13));
    CHECK(dot(a.divisions[i].axis, axes[i]) < 1);
  }
}

// Births and deaths: which state is kept, which rows are recorded, and the world after a failure.
#include "simulation/population.h"

#include "base/maths.h"
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

const LineageEntry& entry(const World& world, const char* path) {
  const auto order = orderByPath(world.lineage);
  const LineageEntry* found = find(world.lineage, order, CellPath::parse(path));
  REQUIRE(found != nullptr);
  return *found;
}

}  // namespace

TEST_CASE("A division makes two cells of one and records it, once the cycle's time has come") {
  World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 3));
  const double volume = world.bodies->volume[0], pressure = world.bodies->pressure[0];
  while (world.cells.path.size() == 1) step(world);
  CHECK(world.clock.time >= 1);
  CHECK(world.clock.time < 1 + world.clock.timeStep);
  CHECK(pathsOf(world) == std::vector<std::string>{"A", "B"});
  CHECK(world.biology->describe(world.cells.state[0]) == "A a1 divide");
  CHECK(world.biology->describe(world.cells.state[1]) == "B a1 divide");
  CHECK(entry(world, "").fate == Fate::divided);
  CHECK(entry(world, "").ended == world.clock.time);
  CHECK(entry(world, "").endedStep == world.clock.step);
  CHECK(entry(world, "A").born == world.clock.time);
  CHECK(entry(world, "B").bornStep == world.clock.step);
  // Forces have been evaluated for the new cells: half spheres at the mother's pressure.
  CHECK(world.bodies->volume[0] + world.bodies->volume[1] == Approx(volume).epsilon(1e-10));
  CHECK(world.bodies->volume[0] == Approx(volume / 2).epsilon(1e-6));
  CHECK(world.bodies->pressure[0] == Approx(pressure).margin(1e-6));
}

TEST_CASE("Daughter A lies where the plane's normal points") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 2);
  for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, -1, 0}, Vector{-1, 2, 3}}) {
    scene.mechanics->division = {DivisionPlane::axis, axis};
    World world = makeWorld(scene);
    while (world.cells.path.size() == 1) step(world);
    const Vector apart = centreOf(world, "A") - centreOf(world, "B");
    CHECK(dot(apart, axis) > 0.9 * norm(apart) * norm(axis));
  }
}

TEST_CASE("The lineage is that of the same DNA without bodies") {
  for (const Scene& with : {scenes::life(), scenes::packed()}) {
    Scene without = with;
    without.mechanics.reset();
    const World a = ranToEnd(with), b = ranToEnd(without);
    const auto orderA = orderByPath(a.lineage);
    for (std::uint32_t i : orderA) {
      const LineageEntry& one = a.lineage.entries[i];
      const LineageEntry& other = entry(b, one.path.text().c_str());
      CHECK(one.fate == other.fate);
      CHECK(a.biology->describe(one.state) == b.biology->describe(other.state));
      CHECK(one.born == Approx(other.born).margin(0.02));
    }
    CHECK(a.lineage.entries.size() == b.lineage.entries.size());
  }
}

TEST_CASE("A cell that dies leaves the physics and stays in the lineage") {
  World world = ranTo(scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(die|A)\ng4(a1|a1)\n", 4), 1.5);
  REQUIRE(world.bodies->count == 2);
  const std::vector<Point> survivor = cellVertices(world, CellPath::parse("B"));
  runTo(world, 2.0);
  CHECK(pathsOf(world) == std::vector<std::string>{"B"});
  CHECK(world.bodies->count == 1);
  CHECK(entry(world, "A").fate == Fate::died);
  CHECK(entry(world, "A").ended == Approx(2).margin(0.02));
  CHECK(entry(world, "B").fate == Fate::alive);
  CHECK_FALSE(finished(world));
  CHECK(cellVertices(world, CellPath::parse("A")).empty());
  CHECK(norm(cellVertices(world, CellPath::parse("B"))[0] - survivor[0]) < 0.5);
  runToEnd(world);
  CHECK(world.clock.time == Approx(4).margin(0.02));
}

TEST_CASE("When everybody is dead the run is over") {
  for (bool withBodies : {true, false}) {
    Scene scene = scenes::withBodies("START: a0\ng1(divide|a0)\ng2(die|A)\ng3(die|B)\n", 100);
    if (!withBodies) scene.mechanics.reset();
    const World world = ranToEnd(scene);
    CHECK(world.clock.time == Approx(2).margin(0.05));
    CHECK(world.cells.path.empty());
    REQUIRE(world.lineage.entries.size() == 3);
    CHECK(entry(world, "A").fate == Fate::died);
    CHECK(entry(world, "B").fate == Fate::died);
    CHECK(measureWorld(world)["cells"] == 0);
    CHECK(measureCells(world).empty());
    CHECK(stateHash(world).text().size() == 32);
  }
}

TEST_CASE("A division that cannot be done leaves the world as it was, other divisions of that moment included") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 9, makeIcosphere(2));
  scene.mechanics->contact = scenes::pairContact;
  scene.mechanics->connections = ConnectionParameters{};
  scene.mechanics->division = {DivisionPlane::axis, {1, 0, 0}};
  Body ball = shakenBody(scenes::scaled(makeIcosphere(2), 0.9), 0, 0), nail = ball;
  ball.pressureConstant = nail.pressureConstant = 100;
  for (Point& x : nail.position) {
    x = x.x > -0.5 ? Point{x.x, 0.05 * x.y, 0.05 * x.z} : x;
    x.y += 3;
  }
  World world = worldOf(scene, {ball, nail});
  const Hash before = stateHash(world);
  const auto failure = failureOf([&] {
    changePopulation(world, Observation(world), {CellChange::divides, CellChange::divides});
  });
  REQUIRE(failure);
  CHECK(failure->cell == "B");
  CHECK_THAT(failure->what(), ContainsSubstring("cannot divide") && ContainsSubstring("cut the cell's volume into"));
  CHECK_THAT(failure->remedy, ContainsSubstring("the cells were not sane before the division: the outer side of "
                                                "cell B"));
  CHECK(stateHash(world) == before);
  CHECK(pathsOf(world) == std::vector<std::string>{"A", "B"});
  // Other divisions are still possible in the world.
  changePopulation(world, Observation(world), {CellChange::divides, CellChange::none});
  CHECK(pathsOf(world) == std::vector<std::string>{"AA", "AB", "B"});
}

TEST_CASE("A cell turned inside out stops the run and is named") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  const std::vector<Body> balls{ballAt(scene.mechanics->mesh, {}), ballAt(scene.mechanics->mesh, {5, 0, 0})};
  World world = worldOf(scene, balls);
  for (int v = 0; v < world.bodies->vertexCount(); ++v)
    world.bodies->position[world.bodies->at(1, v)] = -world.bodies->position[world.bodies->at(1, v)];
  const auto failure = failureOf([&] { step(world); });
  REQUIRE(failure);
  CHECK(failure->cell == "B");
  CHECK(failure->step == 1);
  CHECK_THAT(failure->quantity, ContainsSubstring("inside out"));
  CHECK_THAT(failure->remedy, ContainsSubstring("physics.time_step"));
  World broken = worldOf(scene, balls);
  broken.bodies->velocity[broken.bodies->at(1, 3)] = std::nan("");
  CHECK_THROWS_AS(step(broken), NumericalError);
}

TEST_CASE("A daughter made by shape matching rounds off to the egg's shape at her share of its volume") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 1);
  scene.mechanics->physics.cell.model = CellModel::shapeMatching;
  scene.mechanics->physics.shapeMatching = {1600, 0, 80};
  scene.mechanics->division = {DivisionPlane::axis, {1, 2, 3}};
  scene.stop = {.cycles = {}, .time = 3, .cells = {}};
  scene.cycle.length = 1;
  scene.cycle.perSubstance = {};
  World world = makeWorld(scene);
  while (world.cells.path.size() < 2) step(world);
  const Bodies& b = *world.bodies;
  const double egg = measureVolume(b.mesh.mesh.vertices, b.mesh.mesh.faces);
  double atRest = 0;
  for (int slot : b.slots) {
    CHECK(b.restScale[slot] == Approx(cubeRoot(b.mass(slot))).epsilon(1e-14));  // the egg's mass is 1
    atRest += b.restScale[slot] * b.restScale[slot] * b.restScale[slot];
  }
  CHECK(atRest == Approx(1).epsilon(1e-14));
  const double atBirth = sphericity(b.volume[0], measureArea(takeBody(b, 0).position, b.mesh.mesh.faces));
  CHECK(atBirth < 0.9);
  runTo(world, 1.9);
  for (int slot : b.slots) {
    const double area = measureArea(takeBody(b, slot).position, b.mesh.mesh.faces);
    CHECK(b.volume[slot] == Approx(b.mass(slot) * egg).epsilon(1e-6));
    CHECK(sphericity(b.volume[slot], area) ==
          Approx(sphericity(egg, measureArea(b.mesh.mesh.vertices, b.mesh.mesh.faces))).epsilon(1e-6));
    CHECK(b.pressure[slot] == 0);
  }
  for (const CellMeasures& cell : measureCells(world)) CHECK_FALSE(cell["pressure"]);
  CHECK(measureWorld(world)["mean_pressure"] == 0);
}

TEST_CASE("A division is kept with its axis, the share of daughter A and the ratio of the extents") {
  Scene scene = scenes::withBodies(scenes::uniqueFour, 3);
  scene.mechanics->division = {DivisionPlane::axis, {0, -2, 0}};
  const World world = ranToEnd(scene);
  REQUIRE(world.divisions.size() == 3);
  CHECK(world.divisions[0].path.isEgg());
  CHECK(world.divisions[1].path.text() == "A");
  CHECK(world.divisions[2].path.text() == "B");
  for (const DivisionRecord& d : world.divisions) {
    CHECK(d.axis == Vector{0, -1, 0});
    CHECK(d.time == entry(world, d.path.text().c_str()).ended);
    CHECK(d.step == entry(world, d.path.text().c_str()).endedStep);
  }
  CHECK(world.divisions[0].share == Approx(0.5).epsilon(1e-6));
  CHECK(*world.divisions[0].extentRatio == Approx(1).epsilon(1e-6));  // the egg is round
  CHECK(*world.divisions[1].extentRatio >= 1);
  CHECK(ranToEnd(scenes::lineageOnly(scenes::uniqueFour, 3)).divisions.empty());
  Scene spheres = scenes::spheres();
  spheres.stop = {.cycles = 2, .time = {}, .cells = {}};
  const World balls = ranToEnd(spheres);
  REQUIRE(!balls.divisions.empty());
  CHECK(!balls.divisions[0].extentRatio);
}

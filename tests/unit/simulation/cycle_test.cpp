// Times of cell cycles and the end of a run, with and without bodies.
#include "biology/physical_unit.h"
#include "catch.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("The thesis' four unique cells, from cycle to cycle") {
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 6));
  step(world);
  CHECK(world.clock.time == 1);
  CHECK(pathsOf(world) == std::vector<std::string>{"A", "B"});
  step(world);
  step(world);
  CHECK(world.clock.time == 3);
  CHECK(statesOf(world) == std::vector<std::string>{"a4", "a5", "a6", "a7"});
  CHECK_FALSE(finished(world));
  runToEnd(world);
  CHECK(world.clock.time == 6);
  CHECK(world.clock.step == 6);
  CHECK(statesOf(world) == std::vector<std::string>{"a4", "a5", "a6", "a7"});
}

TEST_CASE("A substance with a cycle length of its own sets the length of the next cycles") {
  Scene scene = scenes::lineageOnly("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(slow|A)\ng4(a1|a1)\ng5(slow|slow)\n", 1);
  scene.cycle.length = 0.5;
  scene.cycle.perSubstance = {{"slow", 0.25}};
  scene.stop = {.cycles = {}, .time = 2, .cells = {}};
  World world = makeWorld(scene);
  std::vector<double> times;
  while (!finished(world)) {
    step(world);
    times.push_back(world.clock.time);
  }
  CHECK(times == std::vector<double>{0.5, 1, 1.25, 1.5, 1.75, 2});
}

TEST_CASE("The first stop condition that holds ends the run") {
  for (bool withBodies : {false, true}) {
    Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
    if (!withBodies) scene.mechanics.reset();
    const auto endOf = [&](StopParameters stop) {
      scene.stop = stop;
      return ranToEnd(scene);
    };
    CAPTURE(withBodies);
    CHECK(endOf({3, {}, {}}).cells.path.size() == 8);
    CHECK(endOf({{}, 2.5, {}}).cells.path.size() == 4);
    CHECK(endOf({{}, {}, 5}).cells.path.size() == 8);
    CHECK(endOf({3, 1.5, {}}).cells.path.size() == 2);
    CHECK(endOf({3, 2.5, 2}).cells.path.size() == 2);
    if (withBodies) {
      CHECK(endOf({{}, 2.5, {}}).clock.time == Approx(2.5).margin(0.01));
      CHECK(endOf({3, {}, {}}).clock.time == Approx(3).margin(0.01));
    }
  }
}

TEST_CASE("The planned end follows from times and cycles, not from numbers of cells") {
  Scene scene = scenes::lineageOnly(scenes::uniqueFour, 4);
  scene.cycle.length = 0.5;
  CHECK(plannedEnd(scene) == 2.0);
  scene.stop.time = 1.75;
  CHECK(plannedEnd(scene) == 1.75);
  scene.stop.time = 3;
  CHECK(plannedEnd(scene) == 2.0);
  scene.stop = {{}, {}, 100};
  CHECK_FALSE(plannedEnd(scene));
}

TEST_CASE("A run to 15 cycles of length 0.1 has 15 cycles, although the lengths add up to 1.5000000000000002") {
  for (const auto& [length, cycles] :
       {std::pair{0.1, 15}, std::pair{0.1, 100}, std::pair{0.7, 6}, std::pair{1.1, 20}}) {
    Scene scene = scenes::lineageOnly("START: a0\ng1(a0|a0)\n", static_cast<std::uint64_t>(cycles));
    scene.cycle.length = length;
    CHECK(ranToEnd(scene).clock.step == static_cast<std::uint64_t>(cycles));
  }
}

TEST_CASE("Cycles that are due between steps run at the next step, and their delays do not add up") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 5);
  scene.mechanics->physics.cell.mass = 10000;
  scene.mechanics->physics.timeStep = 0.3;
  const World world = ranToEnd(scene);
  std::vector<double> births;
  for (const LineageEntry& e : world.lineage.entries)
    if (births.empty() || births.back() != e.born) births.push_back(e.born);
  // The divisions are due at times 1, 2, 3 and 4, and happen at steps 4, 7, 10 and 14.
  REQUIRE(births.size() >= 5);
  CHECK(births[1] == Approx(1.2));
  CHECK(births[2] == Approx(2.1));
  CHECK(births[3] == Approx(3.0));
  CHECK(births[4] == Approx(4.2));
}

TEST_CASE("The lineage knows each cell's last state") {
  for (bool withBodies : {false, true}) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 4);
    if (!withBodies) scene.mechanics.reset();
    const World world = ranToEnd(scene);
    std::vector<std::string> states;
    for (std::uint32_t i : orderByPath(world.lineage))
      states.push_back(world.biology->describe(world.lineage.entries[i].state));
    CHECK(states == std::vector<std::string>{"a1 divide", "a2 divide", "a4", "a5", "a3 divide", "a6", "a7"});
  }
}

TEST_CASE("Another biology may control the cells") {
  struct Once final : IdleUnit {
    double cycleLength(StateId) const override { return 0.5; }
    StateId runCellCycle(const CellContext& cell) override {
      seesBody = cell.physical() && cell.physical()->getVolume() > 0 && cell.physical()->getMass() > 0;
      return cell.state + 1;
    }
    bool wantsToDivide(const CellContext& cell) const override { return cell.state == 1; }
    bool wantsToDie(const CellContext& cell) const override { return cell.state == 3; }
    bool seesBody = false;
  };
  auto unit = std::make_unique<Once>();
  const Once& once = *unit;
  World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 9), std::move(unit), {});
  runToEnd(world);
  CHECK(once.seesBody);
  CHECK(world.lineage.entries.size() == 3);
  CHECK(world.cells.path.empty());
  CHECK(world.clock.time == Approx(1.5).margin(0.02));
}

TEST_CASE("A run that only stop.cells can end fails with a message if it never has so many cells") {
  for (const bool bodies : {false, true}) {
    Scene scene = scenes::lineageOnly("START: a0\ng1(a0|a0)\n", 1);
    scene.stop = {.cycles = {}, .time = {}, .cells = 5};
    scene.cycle.perSubstance = {{"a0", 0.5}};
    if (bodies) {
      scene.mechanics.emplace();
      scene.mechanics->mesh = makeIcosphere(0);
    }
    World world = makeWorld(scene);
    const auto failure = failureOf([&] {
      while (!finished(world) && world.clock.time < 1010) takeSteps(world, 64);
    });
    REQUIRE(failure);
    CHECK_THAT(failure->what(), ContainsSubstring("stop.cells: 5 cells do not live within 1000 cycles: 1 live"));
    CHECK(world.clock.time > 1000);
    scene.stop.time = 1002;  // now stop.time ends the run
    world = makeWorld(scene);
    runToEnd(world);
    CHECK(world.clock.time == Approx(1002).margin(0.5));
  }
}

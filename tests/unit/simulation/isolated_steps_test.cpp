// Many steps in one call equal single steps: bit for bit, at cell cycles, and at the step at which a run fails.
#include "catch.h"
#include "simulation/run_end.h"
#include "worlds.h"

using namespace morula;

namespace {

/// Returns scenes of dividing cells that pass through one another, with every part of a step that needs no other cell.
std::vector<Scene> variants() {
  Scene plain = scenes::withBodies(scenes::everybodyDivides, 5);
  plain.stop.time = 4.5;
  plain.cycle.length = 0.7;
  std::vector<Scene> list{plain};
  const auto vary = [&](const std::string& name, auto change) {
    list.push_back(plain);
    list.back().name = name;
    change(*list.back().mechanics, list.back().mechanics->physics);
  };
  vary("drag in a sphere", [](auto&, auto& p) { p.drag = 0.5, p.shell = ShellParameters{{1, 1, 1}}; });
  vary("ellipsoid", [](auto&, auto& p) { p.shell = ShellParameters{{1.1, 1, 0.96}}; });
  vary("single", [](auto&, auto& p) { p.precision = Precision::binary32; });
  vary("thesis' Verlet", [](auto&, auto& p) { p.integrator = Integrator::thesisVerlet; });
  vary("symplectic Euler", [](auto&, auto& p) { p.integrator = Integrator::symplecticEuler; });
  vary("Runge-Kutta", [](auto&, auto& p) { p.integrator = Integrator::rungeKutta4, p.drag = 0.5; });
  vary("XPBD", [](auto&, auto& p) { p.integrator = Integrator::xpbd, p.timeStep = 0x1p-6; });
  vary("shape matching", [](auto&, auto& p) { p.cell.model = CellModel::shapeMatching; });
  vary("spheres", [](auto& m, auto& p) {
    p.cell.model = CellModel::sphere, p.timeStep = 0x1p-6, m.division.otherwise.plane = DivisionPlane::random;
  });
  vary("coarsening", [](auto& m, auto& p) {
    m.mesh = scenes::scaled(makeIcosphere(2), 0.95), m.coarser = {scenes::scaled(makeIcosphere(1), 0.95)};
    p.coarsen = 0.4;
  });
  return list;
}

/// Returns a world that runs for some time and then blows up: its step is too long for its springs.
World blowingUp() {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 5);
  const Mesh& egg = scene.mechanics->mesh;
  std::vector<Body> cells;
  for (std::uint32_t i = 0; i < 20; ++i) cells.push_back(shakenBody(egg, 0.01, 0.01, i));
  for (Body& b : cells) b.pressureConstant = 200;
  World world = worldOf(scene, cells, {bestIsa(), 2});
  world.clock.timeStep = 0.04;
  return world;
}

std::string whyItFails(World& world, std::uint64_t atOnce) {
  const auto failure = failureOf([&] {
    for (int i = 0; i < 100000; ++i) takeSteps(world, atOnce);
  });
  return failure ? failure->what() : "";
}

}  // namespace

TEST_CASE("Cells that need no other take many steps at once, with the bits of single ones") {
  for (const Scene& scene : variants())
    for (const Execution& how : {Execution{Isa::scalar, 1}, Execution{bestIsa(), 2}}) {
      INFO(scene.name << ", " << name(how.isa));
      World one = makeWorld(scene, how), many = makeWorld(scene, how);
      std::uint64_t most = 1, turns = 0, steps = 0;
      for (; !finished(many); ++turns) {
        most = most * 5 % 97;  // 5, 25, 28, …
        const std::uint64_t before = many.clock.step;
        takeSteps(many, most);
        steps += many.clock.step - before;
        CHECK(many.clock.step - before <= most);
        while (one.clock.step < many.clock.step) step(one);
        REQUIRE(stateHash(one) == stateHash(many));
      }
      CHECK(finished(one));
      CHECK(many.cells.path.size() == 32);
      CHECK(turns * 4 < steps);
    }
}

TEST_CASE("The step that fails is the one that fails alone, and leaves the same state") {
  World one = blowingUp();
  const std::string why = whyItFails(one, 1);
  CHECK_THAT(why, ContainsSubstring("step"));
  for (const std::uint64_t atOnce : {7u, 64u, 1000u}) {
    World many = blowingUp();
    CHECK(whyItFails(many, atOnce) == why);
    CHECK(many.clock.step == one.clock.step);
    CHECK(many.clock.step > 3);
    CHECK(many.bodies->position == one.bodies->position);
    CHECK(many.bodies->velocity == one.bodies->velocity);
  }
}

TEST_CASE("Cells that touch, hold on to each other, turn or grow take one step at a time") {
  Scene touching = scenes::packed(), growing = scenes::withBodies("START: a0\ng1(a0|a0)\ng2(grow|a0)\n", 3);
  growing.mechanics->physics.growth = GrowthParameters{0.1};
  Scene turning = scenes::turning();
  turning.mechanics->contact.reset();
  for (const Scene& scene : {touching, growing, turning}) {
    World world = makeWorld(scene);
    while (world.clock.time < 1.5) takeSteps(world, 1);
    const std::uint64_t before = world.clock.step;
    takeSteps(world, 50);
    CHECK(world.clock.step == before + 1);
  }
}

TEST_CASE("Steps until a time are as many as it takes") {
  for (const double timeStep : {0x1p-7, 0.1, 1 / 3.0, 1e-3})
    for (const double start : {0.0, 0.7, 12345.678})
      for (const double ahead : {-1.0, 0.0, 1e-12, 0.1, 0.3, 0.7, 1.0, 2.5}) {
        Clock clock{start, 1000, timeStep, start, 1000, INFINITY};
        const std::uint64_t steps = stepsUntil(clock, start + ahead);
        CHECK(steps >= 1);
        CHECK(timeAfter(clock, steps) >= start + ahead);
        if (steps > 1) CHECK(timeAfter(clock, steps - 1) < start + ahead);
      }
  CHECK(stepsUntil({0, 0, 0.1, 0, 0, 0}, INFINITY) > 1'000'000'000);
}

// Integrator::fire: its end against forces added up by brute force and against a run through time that comes to
// rest, and its messages when it does not settle.
#include "catch.h"
#include "observation/energy.h"
#include "simulation/settle.h"
#include "worlds.h"

using namespace morula;

namespace {

Scene settled(Scene scene, double tolerance, std::uint64_t evaluations = 200'000) {
  scene = scenes::settling(std::move(scene));
  scene.mechanics->physics.settle = {.tolerance = tolerance, .evaluations = evaluations, .sample = {}};
  return scene;
}

/// Returns a scene in a shell whose cells stop dividing when they are four.
Scene four() {
  Scene scene = scenes::packed();
  scene.stop = {.cycles = 3, .time = {}, .cells = {}};
  return scene;
}

}  // namespace

TEST_CASE("Each step ends with forces within the tolerance, and without motion") {
  for (const double tolerance : {0.1, 1e-3, 1e-9}) {
    World world = makeWorld(settled(four(), tolerance), {Isa::scalar, 1});
    while (!finished(world)) {
      step(world);
      const SettlingRecord& last = world.settlings->back();
      CAPTURE(tolerance, last.step, last.evaluations);
      CHECK(last.step == world.clock.step);
      CHECK(last.residual <= tolerance);
      CHECK_THAT(residualByVertices(world),
                 Catch::Matchers::WithinRel(last.residual, 1e-6) || Catch::Matchers::WithinAbs(0, 1e-12));
      CHECK(fastestVertex(*world.bodies) == 0);
    }
    CHECK(world.cells.path.size() == 8);
  }
}

TEST_CASE("Forces of a world at rest vanish to rounding: 1e-9 of what a spring edge bears") {
  for (const std::uint64_t cells : {1, 4, 64, 128}) {
    Scene scene = scenes::packed();
    scene.stop = {.cycles = {}, .time = {}, .cells = cells};
    World world = ranToEnd(settled(scene, 0.03));
    // Only the last settling has to go this far.
    world.bodies->parameters.settle.tolerance = 1e-10;
    step(world);
    const Bodies& b = *world.bodies;
    double square = 0;
    int vertices = 0;
    for (int slot : b.slots) {
      const double unit = b.parameters.membrane.stiffness * b.meshOf(slot).meanRestLength * b.restScale[slot];
      for (int v = 0; v < b.vertexCount(slot); ++v, ++vertices) {
        const Vector force = b.vertexMass[slot] / unit * b.read(b.acceleration, slot, v);
        square += dot(force, force);
      }
    }
    CAPTURE(cells, b.count, world.settlings->back().evaluations);
    CHECK(std::uint64_t(b.count) >= cells);
    CHECK(std::sqrt(square / vertices) <= 1e-9);
  }
}

TEST_CASE("How far from rest a settling ends is measured, and changes no bit") {
  for (const bool sticks : {false, true}) {
    Scene scene = settled(four(), 0.03);
    if (sticks) scene.mechanics->contact->adhesion.emplace().strength = 0.5;
    const World usual = ranToEnd(scene);
    Scene measured = scene;
    measured.mechanics->physics.settle.sample = 2;
    World sampled = makeWorld(measured);
    while (!finished(sampled)) {
      step(sampled);
      const SettlingRecord& last = sampled.settlings->back();
      CAPTURE(sticks, last.step);
      REQUIRE(last.energyLeft.has_value() == (last.step % 2 == 0));
      if (last.step % 2 != 0) continue;
      // A second world takes the same steps and settles the last to a hundredth of the tolerance: the path is the same.
      World there = makeWorld(scene);
      while (there.clock.step + 1 < last.step) step(there);
      there.bodies->parameters.settle.tolerance = 0.0003;
      step(there);
      CHECK_THAT(*last.displacementLeft, Catch::Matchers::WithinRel(farthestApart(there, sampled), 1e-12));
      const double left = measureEnergy(sampled).total() - measureEnergy(there).total();
      // The difference of energies some thousand times as large loses digits.
      CHECK_THAT(*last.energyLeft, Catch::Matchers::WithinRel(left, 1e-9));
      CHECK(*last.energyLeft > 0);
    }
    for (std::size_t i = 0; i < usual.settlings->size(); ++i) {
      CHECK((*usual.settlings)[i].evaluations == (*sampled.settlings)[i].evaluations);
      CHECK((*usual.settlings)[i].residual == (*sampled.settlings)[i].residual);
    }
    CHECK(farthestApart(usual, sampled) == 0);
    for (int slot : usual.bodies->slots) {
      REQUIRE(usual.bodies->pressure[slot] == sampled.bodies->pressure[slot]);
      for (int v = 0; v < usual.bodies->vertexCount(slot); ++v)
        REQUIRE(norm(usual.bodies->read(usual.bodies->acceleration, slot, v) -
                     sampled.bodies->read(sampled.bodies->acceleration, slot, v)) == 0);
    }
  }
}

TEST_CASE("By FIRE: a cell comes to rest where a run through time with drag ends") {
  // Only a single cell: cells that touch have many states of rest close together, as they turn and fold almost freely.
  Scene scene = scenes::packed();
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "still.dna");
  scene.mechanics->physics.shell.reset();
  scene.mechanics->physics.pressure.constant = 230;
  scene.cells = {{.stretch = {1.1, 1, 0.93}}};
  scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
  const World relaxed = ranToEnd(settled(scene, 1e-11));
  scene.mechanics->physics.drag = 3;
  scene.stop.time = 200;
  const World rest = ranToEnd(scene);
  CHECK(residualByVertices(rest) < 1e-9);
  CHECK(farthestApart(rest, relaxed) <= 1e-6);
}

TEST_CASE("By FIRE: a cell that its gas presses against the shell comes to rest") {
  // Some of these cells would oscillate forever, at half the forces that hold their shape, unless FIRE's inertia
  // followed how often a cell goes uphill.
  for (const double radius : {0.9, 0.93, 0.95})
    for (const double outside : {16.0, 20.0, 25.0, 30.0})
      for (const std::uint64_t seed : {1, 2, 3}) {
        Scene scene = settled(scenes::packed(), 0.03, 2000);
        scene.seed = seed;
        scene.mechanics->mesh = scenes::scaled(makeIcosphere(2), radius);
        scene.mechanics->physics.pressure = {165, outside};
        scene.variation.start = 0.02;
        World world = makeWorld(scene, {Isa::scalar, 1});
        step(world);
        CAPTURE(radius, outside, seed, world.settlings->back().evaluations);
        CHECK(world.settlings->back().residual <= 0.03);
        CHECK(residualByVertices(world) <= 0.03);
      }
}

TEST_CASE("By FIRE: cells grow in small parts, each of which settles") {
  Scene scene = settled(scenes::life(), 0.02);
  World world = makeWorld(scene, {Isa::scalar, 1});
  int parts = 0;
  while (!finished(world)) {
    double fastest = 0;
    for (double growth : world.cells.growth) fastest = std::max(fastest, std::abs(growth));
    const double before = world.clock.time;
    step(world);
    if (fastest == 0) continue;
    CHECK((world.clock.time - before) * fastest * scene.mechanics->physics.growth->rate <= maxGrowth + 1e-12);
    ++parts;
  }
  CHECK(parts >= 10);
}

TEST_CASE("Cells that wait for a size they do not grow to are asked as often as if they grew") {
  Scene scene = settled(scenes::packed(), 0.05);
  scene.mechanics->physics.growth = GrowthParameters{0.1};
  scene.cycle.divisionSize = DivisionSize{DivisionSize::Rule::sizer, 1.5};
  scene.stop = {.cycles = {}, .time = 2, .cells = {}};
  World world = makeWorld(scene, {Isa::scalar, 1});
  std::vector<double> times;
  while (!finished(world)) {
    step(world);
    times.push_back(world.clock.time);
  }
  CHECK(world.cells.path.size() == 1);
  // Times: the start, the cycle at 1 from which on the cell waits, and rounds every 0.02/0.1 to the end.
  CHECK(times.size() == 7);
  for (std::size_t i = 2; i < times.size(); ++i) CHECK(times[i] - times[i - 1] == Approx(0.2));
}

TEST_CASE("By FIRE: the lineage is that of the same scene through time") {
  for (const Scene& scene : {scenes::packed(), scenes::life(), scenes::sticky()}) {
    const World still = ranToEnd(settled(scene, 0.05)), moving = ranToEnd(scene);
    CAPTURE(scene.name);
    REQUIRE(still.cells.path == moving.cells.path);
    for (std::size_t i = 0; i < still.lineage.entries.size(); ++i)
      CHECK(still.lineage.entries[i].path == moving.lineage.entries[i].path);
  }
}

TEST_CASE("Mass, drag, damping and viscosity change nothing") {
  const Scene scene = settled(four(), 1e-3);
  const Hash hash = stateHash(ranToEnd(scene));
  Scene other = scene;
  other.mechanics->physics.drag = 7;
  other.mechanics->physics.membrane.damping = 0.5;
  other.mechanics->contact->damping = 1;
  other.mechanics->contact->viscosity = 0.8;
  CHECK(stateHash(ranToEnd(other)) == hash);
  other.mechanics->physics.cell.mass *= 4;  // a power of two is exact
  const World heavy = ranToEnd(other), light = ranToEnd(scene);
  CHECK(heavy.bodies->position == light.bodies->position);
}

TEST_CASE("By FIRE: events that follow each other closely share a settling") {
  Scene scene = settled(scenes::varied(), 0.05);
  scene.variation.cycle = 0.05;
  const std::size_t each = ranToEnd(scene).settlings->size();
  scene.mechanics->physics.settle.together = 0.3;
  const World shared = ranToEnd(scene);
  CHECK(shared.settlings->size() * 2 <= each);
}

TEST_CASE("A settling that ends early is kept as it is, and one far off ends the run") {
  const auto failure = failureOf([] { ranToEnd(settled(four(), 1e-3, 60)); });
  REQUIRE(failure);
  CHECK_THAT(failure->what(), ContainsSubstring("physics.settle.evaluations"));
  Scene nearly = settled(four(), 0.05, 60);
  const World ended = ranToEnd(nearly);
  CHECK(std::ranges::any_of(*ended.settlings, [](const SettlingRecord& s) { return s.residual > 0.05; }));
}

TEST_CASE("Ten times the tolerance is not too far off to go on from") {
  const auto stepped = [](double tolerance) {
    World world = makeWorld(settled(four(), 1e-9), {Isa::scalar, 1});
    while (world.cells.path.size() < 4) step(world);
    world.bodies->parameters.settle = {.tolerance = tolerance, .evaluations = 20, .sample = {}};
    const bool goesOn = !failureOf([&] { step(world); });
    return std::pair(goesOn, world.settlings->back().residual);
  };
  const auto [goesOn, left] = stepped(1e-9);
  CHECK_FALSE(goesOn);
  double tolerance = left / 10;
  while (10 * tolerance < left) tolerance = std::nextafter(tolerance, 1.0);
  REQUIRE(10 * tolerance == left);
  CHECK(stepped(tolerance) == std::pair(true, left));
  CHECK(stepped(tolerance * (1 - 1e-9)) == std::pair(false, left));
}

TEST_CASE("The cell that is told where a settling ends far from rest is the one with the largest forces") {
  Scene scene = settled(four(), 1e-9);
  scene.mechanics->division.rules = {{.of = {"a*"}, .share = 0.8}};  // makes masses differ
  std::set<std::string> told;
  for (std::uint64_t evaluations = 2; evaluations < 60; evaluations += 3) {
    World world = makeWorld(scene, {Isa::scalar, 1});
    while (world.cells.path.size() < 4) step(world);
    world.bodies->parameters.settle.evaluations = evaluations;
    const auto failure = failureOf([&] { runToEnd(world); });
    REQUIRE(failure);
    const std::string cell = failure->cell;
    const Bodies& b = *world.bodies;
    const auto force = [&](std::size_t c) {
      double square = 0;
      for (int v = 0; v < b.vertexCount(b.slots[c]); ++v) {
        const Vector f = b.vertexMass[b.slots[c]] * b.read(b.acceleration, b.slots[c], v);
        square += dot(f, f);
      }
      return square;
    };
    std::size_t most = 0;
    for (std::size_t c = 1; c < b.slots.size(); ++c)
      if (force(c) > force(most)) most = c;
    CAPTURE(evaluations);
    CHECK(cell == world.cells.path[most].text());
    told.insert(cell);
  }
  CHECK(told.size() > 1);
}

TEST_CASE("Events that share a settling cannot be as far apart as the cycles of one cell") {
  Scene scene = settled(four(), 0.02);
  scene.mechanics->physics.settle.together = scene.cycle.length;
  CHECK_THROWS_AS(makeWorld(scene), InputError);
}

// Quasi-static growth: how many evaluations it takes and where they lead to, against forces added up by brute force and a
// run through time that comes to rest.
#include "simulation/settle.h"

#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

Scene quasiStatic(const Scene& scene) { return scenes::settling(scene); }

Scene toRest(const Scene& scene, double residual) {
  Scene s = quasiStatic(scene);
  s.mechanics->physics.quasiStatic.residual = residual;
  return s;
}

std::uint64_t evaluationsIn(const World& world) {
  std::uint64_t sum = 0;
  for (const SettlingRecord& settling : *world.settlings) sum += settling.evaluations;
  return sum;
}

/// Returns a scene in a shell whose cells stop dividing when they are eight.
Scene eight() {
  Scene scene = scenes::packed();
  scene.stop = {.cycles = 3, .time = {}, .cells = {}};
  return scene;
}

}  // namespace

TEST_CASE("Evaluations follow the time that a run takes, the pace of cycles and the root of a mesh's vertices") {
  for (const int level : {0, 1})
    for (const double cycle : {1.0, 0.25}) {
      Scene scene = quasiStatic(scenes::packed());
      scene.mechanics->mesh = scenes::scaled(makeIcosphere(level), 0.9);
      scene.mechanics->physics.quasiStatic.evaluations = 12;
      scene.cycle.length = cycle;
      scene.stop = {.cycles = {}, .time = 2.5 * cycle, .cells = {}};
      scene.variation.cycle = 0.1;  // rounds of their own for each cell
      const World world = ranToEnd(scene);
      CAPTURE(level, cycle);
      CHECK(world.settlings->size() >= 4);
      const double cycles = world.clock.nextCycle / cycle + 0.13;  // an eighth of a cycle at the end of the run
      CHECK(std::abs(double(evaluationsIn(world)) - cycles * 12 * std::sqrt(level == 0 ? 12 : 42)) <= 2);
      CHECK(evaluationsPerTime(world.model, 42) == Approx(12 * std::sqrt(42) / cycle));
    }
}

TEST_CASE("What a settling leaves is kept with it") {
  World world = makeWorld(quasiStatic(eight()), {Isa::scalar, 1});
  while (!finished(world)) {
    const std::size_t before = world.settlings->size();
    step(world);
    if (world.settlings->size() == before) continue;  // the stop is no event
    const SettlingRecord& last = world.settlings->back();
    CAPTURE(last.step, last.evaluations);
    CHECK(last.step == world.clock.step);
    CHECK_THAT(residualByVertices(world), Catch::Matchers::WithinRel(last.residual, 1e-9));
    CHECK(last.evaluations > 100);
    CHECK(last.energyLeft > 0);
    CHECK_FALSE(last.displacementLeft);
    CHECK(fastestVertex(*world.bodies) > 0);  // the next settling goes on
  }
  CHECK(world.cells.path.size() == 8);
}

TEST_CASE("The end settles to the residual that the scene gives: 1e-9 on one cell, four and sixty-four") {
  for (const std::uint64_t cells : {1, 4, 64}) {
    Scene scene = scenes::packed();
    if (cells == 1) scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
    else scene.stop = {.cycles = {}, .time = {}, .cells = cells};
    const World world = ranToEnd(toRest(scene, 1e-9));
    const SettlingRecord& last = world.settlings->back();
    CAPTURE(cells, last.evaluations, last.residual);
    CHECK(std::uint64_t(world.bodies->count) >= cells);
    CHECK(residualByVertices(world) <= 1e-9);
    CHECK(last.residual <= 1e-9);
    if (cells > 1) CHECK(last.displacementLeft > 0);  // an egg begins at rest
    CHECK(last.energyLeft < 1e-15);
    const World before = ranToEnd(quasiStatic(scene));
    CHECK(*last.displacementLeft == Approx(farthestApart(before, world)).margin(1e-12));
  }
}

TEST_CASE("A cell comes to rest where a run through time with drag ends") {
  // Only a single cell: cells that touch have many states of rest close together, as they turn and fold almost freely.
  Scene scene = scenes::packed();
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "still.dna");
  scene.mechanics->physics.shell.reset();
  scene.mechanics->physics.pressure.constant = 230;
  scene.cells = {{.stretch = {1.1, 1, 0.93}}};
  scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
  const World relaxed = ranToEnd(toRest(scene, 1e-11));
  scene.mechanics->physics.drag = 3;
  scene.stop.time = 200;
  const World rest = ranToEnd(scene);
  CHECK(residualByVertices(rest) < 1e-9);
  CHECK(farthestApart(rest, relaxed) <= 1e-6);
}

TEST_CASE("A cell that its gas presses against the shell comes to rest") {
  // Membranes fold, and some of these cells would oscillate forever unless inertia followed the stiffness that their
  // motion meets.
  for (const double radius : {0.9, 0.93, 0.95})
    for (const double outside : {16.0, 20.0, 25.0, 30.0})
      for (const std::uint64_t seed : {1, 2, 3}) {
        Scene scene = quasiStatic(scenes::packed());
        scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "still.dna");
        scene.seed = seed;
        scene.mechanics->mesh = scenes::scaled(makeIcosphere(2), radius);
        scene.mechanics->physics.pressure = {165, outside};
        scene.variation.start = 0.02;
        scene.stop = {.cycles = 4, .time = {}, .cells = {}};
        const World world = ranToEnd(scene);
        CAPTURE(radius, outside, seed);
        CHECK(residualByVertices(world) <= 0.03);
      }
}

TEST_CASE("Cells grow in small parts, each of which settles") {
  const Scene scene = quasiStatic(scenes::life());
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

TEST_CASE("The lineage is that of the same scene through time") {
  for (const Scene& scene : {scenes::packed(), scenes::life(), scenes::sticky()}) {
    const World still = ranToEnd(quasiStatic(scene)), moving = ranToEnd(scene);
    CAPTURE(scene.name);
    REQUIRE(still.cells.path == moving.cells.path);
    for (std::size_t i = 0; i < still.lineage.entries.size(); ++i)
      CHECK(still.lineage.entries[i].path == moving.lineage.entries[i].path);
  }
}

TEST_CASE("Drag, damping and viscosity change nothing, and mass no place") {
  const Scene scene = quasiStatic(eight());
  const World light = ranToEnd(scene);
  Scene other = scene;
  other.mechanics->physics.drag = 7;
  other.mechanics->physics.membrane.damping = 0.5;
  other.mechanics->contact->damping = 1;
  other.mechanics->contact->viscosity = 0.8;
  CHECK(stateHash(ranToEnd(other)) == stateHash(light));
  other.mechanics->physics.cell.mass *= 4;  // a power of two is exact
  CHECK(ranToEnd(other).bodies->position == light.bodies->position);
}

TEST_CASE("A run whose unit of time is another settles the same way") {
  const Scene scene = quasiStatic(eight());
  Scene slow = scene;
  slow.cycle.length = 16;  // a power of two is exact
  CHECK(ranToEnd(slow).bodies->position == ranToEnd(scene).bodies->position);
}

TEST_CASE("Events that follow each other closely share a settling") {
  Scene scene = quasiStatic(scenes::varied());
  scene.variation.cycle = 0.05;
  const World each = ranToEnd(scene);
  scene.mechanics->physics.quasiStatic.together = 0.3;
  const World shared = ranToEnd(scene);
  CHECK(shared.settlings->size() < each.settlings->size());
}

TEST_CASE("Events that share a settling cannot be as far apart as the cycles of one cell, and its key is told") {
  Scene scene = quasiStatic(eight());
  scene.mechanics->physics.quasiStatic.together = scene.cycle.length;
  REQUIRE_THROWS_AS(makeWorld(scene), InputError);
  try {
    makeWorld(scene);
  } catch (const InputError& e) { CHECK_THAT(e.what(), ContainsSubstring("quasi-static.together")); }
}

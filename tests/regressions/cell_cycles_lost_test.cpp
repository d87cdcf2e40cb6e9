// A time step longer than a cell's cycle ran one cycle per step: `cycle: {length: 0.005}`, `stop: {cycles: 5}` with
// bodies ended with 4 cells at time 0.03 instead of 32 at 0.025, and exit code 0. Now runs with bodies agree with the
// lineage of the same scene, for random DNA and cycle lengths, several integrators, automatic and given steps.
#include <random>
#include <set>

#include "biology/lineage.h"
#include "catch.h"
#include "launch.h"
#include "scenes.h"

using namespace morula;
using namespace morula::test;

namespace {

using Random = std::mt19937;

int below(Random& random, int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }

/// Returns random DNA: some cells divide, some die, states change. Each of the substances s0 … s5 makes the next, so
/// that every cell always holds some.
std::string randomDna(Random& random) {
  std::set<std::string> genes{"divide|s0"};
  for (int s = 0; s < 6; ++s) genes.insert("s" + std::to_string((s + 1) % 6) + "|s" + std::to_string(s));
  const auto substance = [&] { return "s" + std::to_string(below(random, 6)); };
  for (int i = below(random, 10); i >= 0; --i) {
    const int kind = below(random, 10);
    const char* const asymmetries[] = {"", ",A", ",B"};
    const std::string input = substance() + asymmetries[below(random, 3)];
    genes.insert((kind < 4 ? "divide" : kind == 4 ? "die" : substance()) + "|" + input);
  }
  std::string dna = "START: s0\n";
  int number = 0;
  for (const std::string& gene : genes) dna += "g" + std::to_string(number++) + "(" + gene + ")\n";
  return dna;
}

double randomLength(Random& random) {
  const double lengths[] = {0.05, 0.1, 0.125, 0.3, 1.0 / 3, 0.7, 1, 0.0625 + below(random, 1000) * 0.001};
  return lengths[below(random, 8)];
}

Scene randomScene(Random& random) {
  Scene scene = scenes::withBodies("START: s0\ng0(s0|s0)\n", 1);
  scene.dna = parseDna(randomDna(random), "random.dna");
  scene.cycle.length = randomLength(random);
  for (int s = 0; s < 6; ++s)
    if (below(random, 3) == 0) scene.cycle.perSubstance["s" + std::to_string(s)] = randomLength(random);
  scene.stop = {};
  const int stop = below(random, 4);
  if (stop != 1) scene.stop.cycles = 1 + below(random, 6);
  if (stop == 1 || stop == 3) scene.stop.time = 0.2 + below(random, 100) * 0.01;
  scene.stop.cells = 2 + below(random, 12);  // keeps the test short

  // Bodies hardly move, so that only cycles and stops limit steps, and are free to divide.
  PhysicsParameters& p = scene.mechanics->physics;
  p.cell = {1, 1e6, CellModel::sphere};
  p.drag = 0.01;
  scene.mechanics->mesh = makeIcosphere(1);
  scene.mechanics->division = {DivisionPlane::axis, {1, 2, 3}};
  const Integrator integrators[] = {Integrator::velocityVerlet, Integrator::thesisVerlet,  Integrator::symplecticEuler,
                                    Integrator::rungeKutta4,    Integrator::explicitEuler, Integrator::xpbd};
  p.integrator = integrators[below(random, 6)];
  double shortest = scene.cycle.length;
  for (const auto& [substance, length] : scene.cycle.perSubstance) shortest = std::min(shortest, length);
  const double end = plannedEnd(scene).value_or(INFINITY);
  if (p.integrator == Integrator::xpbd || below(random, 2) == 0) {
    const double shares[] = {1, 1, 0.5, 0.3, 0.77};
    p.timeStep = std::min(shortest, end) * shares[below(random, 5)];
  }
  return scene;
}

World ranToEnd(const Scene& scene, bool manyAtOnce) {
  World world = makeWorld(scene);
  for (int steps = 0; !finished(world); ++steps) {
    REQUIRE(steps < 100000);
    if (manyAtOnce) takeSteps(world, 7);
    else step(world);
  }
  return world;
}

}  // namespace

TEST_CASE("the lineage with bodies is the lineage without") {
  Random random(20080617);
  int births = 0, deaths = 0, automatic = 0;
  for (int round = 0; round < 400; ++round) {
    const Scene scene = randomScene(random);
    Scene genes = scene;
    genes.mechanics.reset();
    const World lineage = ranToEnd(genes, false), world = ranToEnd(scene, round % 2 == 0);
    CAPTURE(round, scene.cycle.length, world.clock.timeStep, world.clock.time, lineage.clock.time);
    automatic += !scene.mechanics->physics.timeStep;
    REQUIRE(world.lineage.entries.size() == lineage.lineage.entries.size());
    REQUIRE(world.cells.path == lineage.cells.path);
    const auto a = orderByPath(world.lineage), b = orderByPath(lineage.lineage);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const LineageEntry &x = world.lineage.entries[a[i]], &y = lineage.lineage.entries[b[i]];
      REQUIRE(x.path == y.path);
      REQUIRE(x.fate == y.fate);
      REQUIRE(world.biology->describe(x.state) == lineage.biology->describe(y.state));
      const double step = world.timeSteps.front().timeStep;
      CHECK(x.born >= y.born * (1 - 1e-9));
      CHECK(x.born <= y.born + step);
      births += x.born > 0;
      deaths += x.fate == Fate::died;
    }
    for (const TimeStepChange& t : world.timeSteps) CHECK(t.timeStep <= scene.cycle.length);
    // The run ends at its stop: exactly if the program chooses the steps, else within one step.
    const auto end = plannedEnd(scene);
    if (end && !world.cells.path.empty() && world.cells.path.size() < *scene.stop.cells) {
      const double late = scene.mechanics->physics.timeStep.value_or(0);
      CHECK(world.clock.time >= *end * (1 - 1e-9));
      CHECK(world.clock.time <= *end * (1 + 1e-9) + late);
    }
  }
  CHECK(births > 1000);
  CHECK(deaths > 20);
  CHECK(automatic > 100);
}

TEST_CASE("a shell's cycles are not lost either, and its run ends at its stop") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 5);
  scene.cycle.length = 0.005;
  const World world = ranToEnd(scene, false);
  CHECK(world.cells.path.size() == 32);
  CHECK(world.clock.time == Approx(0.025).epsilon(1e-9));
}

TEST_CASE("a heavy cell's steps are no longer than its cycles") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 5);
  scene.mechanics->physics.cell.mass = 1e5;
  const World world = ranToEnd(scene, false);
  CHECK(world.cells.path.size() == 32);
  CHECK(world.clock.time == 5);
}

TEST_CASE("a time step longer than the shortest cycle, or than the run, is refused with both numbers") {
  const auto refused = [](const std::string& change, const std::string& because) {
    refuses({"validate", uniqueFour, "--set", "physics.time_step=0.001", "--set", change}, 3, because);
  };
  refused("cycle.length=0.0005", "physics.time_step: 0.001 is longer than the shortest cell cycle, cycle.length 5e-04");
  refused("cycle.per-substance={a1: 0.0005}", "cycle.per-substance.a1 5e-04");
  refused("stop.time=0.0005", "physics.time_step: 0.001 is longer than the whole run, which stops at 5e-04");
}

TEST_CASE("cycles too short for their run are refused, not counted one after the other") {
  refuses({"validate", "scenarios/thesis/elegans-1024.yaml", "--set", "cycle.length=1e-20", "--set", "stop={time: 1}"},
          3, "cycle.length: 1e-20 is too short");
}

// Predictions against the runs themselves.
#include "parts/prediction.h"

#include <cmath>

#include "bench/packed_world.h"
#include "bench/work.h"
#include "catch.h"
#include "contacts/contacts.h"
#include "observation/measures.h"
#include "parts/rates.h"
#include "scenes.h"
#include "simulation/memory.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

struct Counted {
  World world;
  double steps = 0, pairs = 0;
};

Counted ran(const Scene& scene) {
  Counted c{makeWorld(scene)};
  while (!finished(c.world)) {
    step(c.world);
    ++c.steps;
    if (c.world.contacts) c.pairs += double(c.world.contacts->list.pairs);
  }
  return c;
}

struct Predicted {
  Life life;
  TrialRun trial;
  std::vector<EraCounts> eras;
};

Predicted predict(const Scene& scene, double vertexSteps) {
  const Life life = predictLife(scene);
  TrialRun trial = tryBeginning(makeWorld(scene), life, vertexSteps);
  auto eras = extrapolate(life, trial);
  return {life, std::move(trial), std::move(eras)};
}

double sumOf(double EraCounts::*count, const std::vector<EraCounts>& eras) {
  double sum = 0;
  for (const EraCounts& era : eras) sum += era.*count;
  return sum;
}

/// Returns a scene of sixty-four cells in a shell.
Scene crowd() {
  Scene s = scenes::packed();
  s.mechanics->physics.drag = 5;
  s.mechanics->contact = scenes::pairContactWithViscosity;
  s.stop.cycles = 7;
  s.stop.time = 6.125;
  return s;
}

}  // namespace

TEST_CASE("A life in eras: as many cells as the run has, from birth to the stop") {
  Scene scene = scenes::lineageOnly(scenes::uniqueFour, 6);
  Life life = predictLife(scene);
  REQUIRE(life.eras.size() == 3);
  for (int i = 0; i < 3; ++i) {
    CHECK(life.eras[i].cells == 1u << i);
    CHECK(life.eras[i].generation == i);
    CHECK(life.eras[i].from == i);
  }
  CHECK(life.eras[1].to == 2);
  CHECK(life.eras[2].to == 6);
  CHECK(life.divisions == 3);
  CHECK(life.whole);

  scene = scenes::lineageOnly(scenes::everybodyDivides, 40);
  scene.stop.time = 4.5;
  life = predictLife(scene);
  CHECK(life.maxCells() == 16);
  CHECK(life.eras.back().to == 4.5);
  scene.stop.cells = 8;
  life = predictLife(scene);
  CHECK(life.maxCells() == 8);
  CHECK(life.eras.back().to == 3);
  scene.stop = {};
  scene.stop.cycles = 40;
  life = predictLife(scene, 1000);
  CHECK_FALSE(life.whole);
  CHECK(life.maxCells() >= 512);

  // Predicted deaths are compared with the run itself.
  scene = scenes::lineageOnly(scenes::eventful, 8);
  World world = makeWorld(scene);
  life = predictLife(scene);
  std::vector<std::uint64_t> counts{1};
  while (!finished(world)) {
    step(world);
    if (world.cells.path.size() != counts.back()) counts.push_back(world.cells.path.size());
  }
  std::vector<std::uint64_t> predicted;
  for (const Era& era : life.eras)
    if (predicted.empty() || era.cells != predicted.back()) predicted.push_back(era.cells);
  CHECK(predicted == counts);
  CHECK(life.eras.back().cells < life.maxCells());
}

TEST_CASE("A trial run that comes to the end has counted exactly what a run counts") {
  for (const Scene& scene : {scenes::packed(), scenes::ellipsoid(), scenes::thesis(), scenes::life()}) {
    CAPTURE(scene.name);
    const Predicted f = predict(scene, 1e9);
    const Counted real = ran(scene);
    CHECK(f.trial.whole);
    CHECK(stateHash(f.trial.world) == stateHash(real.world));
    CHECK(sumOf(&EraCounts::steps, f.eras) == real.steps);
    CHECK(f.life.eras.back().cells == real.world.cells.path.size());
    const MemoryUse m = extrapolateMemory(f.life, f.trial), r = measureMemory(real.world);
    CHECK(m.total() == Approx(double(r.total())).epsilon(0.1));
  }
}

TEST_CASE("From its first cells a crowd is predicted: steps, pairs, and memory to 10 %") {
  const Scene scene = crowd();
  const Counted real = ran(scene);
  REQUIRE(real.world.cells.path.size() == 64);
  // The trial run reaches eight cells, on every machine.
  const Predicted f = predict(scene, 1.2e5);
  REQUIRE_FALSE(f.trial.whole);
  CHECK(f.trial.world.bodies->count == 8);
  CHECK(f.life.maxCells() == 64);
  CHECK(sumOf(&EraCounts::steps, f.eras) == Approx(real.steps).epsilon(0.3));
  CHECK(sumOf(&EraCounts::pairs, f.eras) == Approx(real.pairs).epsilon(0.3));
  const MemoryUse m = extrapolateMemory(f.life, f.trial), r = measureMemory(real.world);
  CHECK(double(m.total()) == Approx(double(r.total())).epsilon(0.1));
  CHECK(m.bodies == Approx(double(r.bodies)).epsilon(0.01));
  CHECK(m.snapshots == Approx(double(r.snapshots)).epsilon(0.01));
  CHECK(m.listPairs == Approx(double(r.listPairs)).epsilon(0.3));  // as precise as pairs
  CHECK(m.cells == Approx(double(r.cells)).epsilon(0.1));
}

TEST_CASE("Memory is that of the arrays") {
  World world = makeWorld(scenes::withBodies(scenes::uniqueFour, 3));
  const MemoryUse one = measureMemory(world);
  const std::size_t n = world.bodies->vertexCount();
  CHECK(one.contact() == 0);
  CHECK(one.connections == 0);
  // One block holds x, v and a of eight lanes, six numbers for each lane, and the cell's place.
  CHECK(one.bodies == 8 * (3 * 24 * n + 6 * 8) + sizeof(int) + sizeof(BlockPlace));
  world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 3));
  CHECK(measureMemory(world).total() == measureMemory(world).cells);
  world = makeWorld(scenes::packed());
  CHECK(measureMemory(world).snapshots > 64 * 8 * n);
}

TEST_CASE("Packed cells take at most 400 B per vertex, with all that finds and keeps their contacts") {
  World world = makePackedWorld({.cells = 64});
  for (int i = 0; i < 100; ++i) step(world);
  const double vertices = world.bodies->livingVertices;
  CHECK(world.contacts->list.pairs > 4 * vertices);
  CHECK(measureMemory(world).total() / vertices <= 400);
}

TEST_CASE("Time steps of later generations are those that a run takes") {
  Scene scene = crowd();
  const Life life = predictLife(scene);
  const TrialRun whole = tryBeginning(makeWorld(scene), life, 1e9);
  const TrialRun start = tryBeginning(makeWorld(scene), life, 1.2e5);
  REQUIRE(start.generation == 3);
  REQUIRE(whole.generation == 6);
  CHECK(predictTimeStepLimit(whole, 6) == Approx(whole.timeStepLimit));
  CHECK(predictTimeStepLimit(start, 3) == Approx(start.timeStepLimit));
  CHECK(predictTimeStepLimit(start, 6) == Approx(whole.timeStepLimit).epsilon(0.2));
  // The limit of a free round egg before any step fits the step that makeWorld chose.
  const TrialRun nothing = tryBeginning(makeWorld(scene), life, 0);
  const double limit = predictTimeStepLimit(nothing, 0), step = nothing.world.clock.timeStep;
  CHECK(step <= limit);
  CHECK(2 * step > limit);
}

TEST_CASE("Measuring rates changes nothing, and what the scene lacks has none") {
  for (const Scene& scene : {scenes::packed(), scenes::ellipsoid(), scenes::thesis()}) {
    CAPTURE(scene.name);
    World world = makeWorld(scene);
    while (world.cells.path.size() < 4) step(world);
    const Hash before = stateHash(world);
    const auto pairs = world.contacts->list.pairs;
    const StepRates rates = measureRates(world);
    CHECK(stateHash(world) == before);
    CHECK(world.contacts->list.pairs == pairs);
    // Rates are differences of times, which may vanish on a busy machine; shares that come from counting are exact.
    PhysicsParameters plain = scene.mechanics->physics;
    plain.membrane.damping = plain.drag = 0;
    const double share = springShare(world.bodies->mesh, plain);
    CHECK(rates.springs >= 0);
    CHECK((1 - share) * rates.springs == Approx(share * rates.pressure));
    CHECK(rates.integration > 0);
    CHECK(rates.pair > 0);
    CHECK(rates.search > 0);
    const auto& p = scene.mechanics->physics;
    if (p.drag == 0) CHECK(rates.drag == 0);
    if (scene.mechanics->contact->viscosity == 0) CHECK(rates.viscosityOfPair == 0);
    if (!world.connections) CHECK(rates.connections == 0);
    step(world);  // the world continues undisturbed
    World other = makeWorld(scene);
    while (other.clock.step < world.clock.step) step(other);
    CHECK(stateHash(world) == stateHash(other));
  }
  World plain = makeWorld(scenes::withBodies(scenes::uniqueFour, 3));
  const StepRates rates = measureRates(plain);
  CHECK(rates.shell == 0);
  CHECK(rates.drag == 0);
  CHECK(rates.pair == 0);
  CHECK(rates.search == 0);
  CHECK(rates.snapshots == 0);
}

TEST_CASE("Lanes that nobody uses are paid for") {
  CHECK(laneShare(Isa::scalar, 3) == 1);
  CHECK(laneShare(Isa::avx2, 1) == 4);
  CHECK(laneShare(Isa::avx2, 4) == 1);
  CHECK(laneShare(Isa::avx512, 10) == 1.6);
  CHECK(laneShare(Isa::avx512, 0) == 1);
}

TEST_CASE("A prediction has a line for each part, and shares of one whole") {
  const auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/unique-four.yaml");
  const Prediction f = predictCost(scenario, {.trial = 2e5});
  CHECK(f.cells == 4);
  CHECK(f.vertices == 162);
  std::size_t engaged = 0;
  for (const Part& part : partsOf(scenario, {})) engaged += part.engaged;
  CHECK(f.costs.size() == engaged);
  double sum = 0;
  for (const PartCost& c : f.costs) {
    CAPTURE(c.part.name);
    if (c.seconds) CHECK(*c.seconds >= 0);
    sum += c.afterwards ? 0 : c.seconds.value_or(0);
  }
  CHECK(sum == f.seconds());
  CHECK(sum > 0);
  const std::string text = textOf(describe(f, "unique-four"));
  CHECK_THAT(text, ContainsSubstring("up to 4 cells of 162 vertices") &&
                       ContainsSubstring("absent parts, which cost nothing") &&
                       ContainsSubstring("unique-four.yaml:33:9: physics.drag"));
}

TEST_CASE("Odd lives have predictions, too: nothing to do, everybody dead, far too many") {
  auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/unique-four.yaml");
  const PredictionOptions options{.trial = 1e5};
  scenario.scene.mechanics->mesh = makeIcosphere(0);
  scenario.scene.stop = {};
  scenario.scene.stop.cells = 1;
  Prediction f = predictCost(scenario, options);
  CHECK(f.steps == 0);
  for (const PartCost& c : f.costs) CHECK_FALSE(c.nsPerVertexStep);
  scenario.scene.stop.cells.reset();
  scenario.scene.stop.cycles = 3;
  scenario.scene.dna = parseDna("START: a0\ng1(die|a0)\n", "test.dna");
  f = predictCost(scenario, options);
  CHECK(f.steps > 0);
  CHECK(f.cells == 1);
  CHECK(f.seconds() > 1e-6);
  scenario.scene.dna = parseDna(scenes::everybodyDivides, "test.dna");
  scenario.scene.stop.cycles = 60;
  f = predictCost(scenario, options);
  CHECK(f.cells >= 100'000);
  CHECK(std::isfinite(f.seconds()));
  CHECK(f.bytes() > 1e9);
  CHECK_THAT(textOf(describe(f, "many")), ContainsSubstring("many: at least "));
}

TEST_CASE("A fixed time step that later cells will not stand is told beforehand") {
  auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/elegans-128.yaml");
  const PredictionOptions options{.trial = 2e5};
  scenario.scene.mechanics->mesh = makeIcosphere(0);
  scenario.scene.mechanics->physics.timeStep = 0x1p-9;
  const Prediction f = predictCost(scenario, options);
  REQUIRE(f.remarks.size() == 1);
  CHECK_THAT(f.remarks[0], ContainsSubstring("physics.time_step will be too long from "));
  scenario.scene.mechanics->physics.timeStep = 0x1p-14;
  CHECK(predictCost(scenario, options).remarks.empty());
}

TEST_CASE("The prediction of a lineage needs no trial run") {
  const auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/elegans-1024.yaml");
  const Prediction f = predictCost(scenario, {});
  CHECK(f.cells == 1024);
  CHECK(f.vertices == 0);
  CHECK(f.triedWhole);
  for (const PartCost& c : f.costs)
    CHECK((c.part.name == "biology" || c.part.name == "samples" || c.part.name == "pictures"));
  CHECK(f.bytes() > 2047 * sizeof(LineageEntry));
}

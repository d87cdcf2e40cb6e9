// Records of a run: everything that was requested, at its times, and no more.
#include "store/recorder.h"

#include <algorithm>
#include <tuple>

#include "biology/full_tree.h"
#include "catch.h"
#include "example_run.h"
#include "simulation/make_world.h"
#include "simulation/simulation.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

Scene fourCells(bool mechanics) {
  Scene scene;
  scene.name = "four-cells";
  scene.dna = parseDna(makeFullTreeDna(2), "test.dna");
  scene.cycle.length = 0.125;
  scene.stop.cycles = 3;
  if (mechanics) {
    scene.mechanics.emplace();
    scene.mechanics->mesh = makeIcosphere(1);
    scene.mechanics->physics.membrane.damping = 0.5;
    scene.mechanics->physics.pressure.outside = 1;
    scene.mechanics->physics.drag = 5;
    scene.mechanics->contact.emplace();
    scene.mechanics->connections.emplace();
  }
  return scene;
}

struct Run {
  World world;
  Recorder recorder;
  int sampled = 0;
  Run(const Scene& scene, RecordOptions options) : world(makeWorld(scene)), recorder(options) {
    for (observe(); !finished(world); observe()) step(world);
  }
  void observe() {
    recorder.observe(world);
    sampled += recorder.sampled();
  }
};

}  // namespace

TEST_CASE("a run that was asked for nothing is measured at its start and at its end") {
  Run run(fourCells(true), {});
  const RunResults results = run.recorder.take(run.world);
  REQUIRE(results.samples.size() == 2);
  CHECK(results.samples[0].world.step == 0);
  CHECK(results.samples[1].world.step == run.world.clock.step);
  CHECK(results.chain.empty());
  CHECK(results.lineage.size() == 7);
  CHECK(results.timeSteps.size() == run.world.timeSteps.size());
  CHECK_FALSE(results.connections.empty());
  CHECK(results.checks.empty());
}

TEST_CASE("samples are taken at the multiples and at the end") {
  Run run(fourCells(true), {.every = 0.1, .hashEvery = {}});  // 0.1 is no multiple of the time step
  const double timeStep = run.world.timeSteps.front().timeStep;
  const RunResults results = run.recorder.take(run.world);
  REQUIRE(results.samples.size() == 5);  // 0, 0.1, 0.2, 0.3 and the end, 0.375
  CHECK(run.sampled == 4);
  for (int i = 0; i < 4; ++i) {
    const double time = results.samples[static_cast<std::size_t>(i)].world.time;
    CHECK(time >= i * 0.1);
    CHECK(time < i * 0.1 + timeStep);
  }
  CHECK(results.samples.back().world.step == run.world.clock.step);
  for (const Sample& s : results.samples) {
    CHECK(s.cells.size() == s.world.at("cells"));
    for (const CellMeasures& c : s.cells) CHECK(results.stateTexts.contains(c.state));
  }
}

TEST_CASE("samples are taken when so many cells live for the first time, beside the others") {
  for (const bool mechanics : {true, false}) {
    Run run(fourCells(mechanics), {.atCells = {1, 2, 3, 4, 5}});
    const RunResults results = run.recorder.take(run.world);
    std::vector<double> cells;
    for (const Sample& s : results.samples) cells.push_back(s.world.at("cells"));
    CHECK(cells == std::vector<double>{1, 2, 4, 4});  // 3 is passed together with 4; the last sample is the end's
    for (std::size_t i = 1; i < 3; ++i) {             // exactly at the birth
      const double time = results.samples[i].world.time;
      CHECK(std::ranges::count_if(results.lineage, [&](const LineageEntry& e) { return e.born == time; }) ==
            static_cast<int>(cells[i]));
    }
  }
}

TEST_CASE(
    "numbers of cells are looked for where cells take many steps at once, and samples at times go on as they were") {
  Scene scene = fourCells(true);
  scene.mechanics->contact.reset();
  scene.mechanics->connections.reset();
  World world = makeWorld(scene);
  Recorder recorder({.every = 0.1, .atCells = {2, 4}});
  for (recorder.observe(world); !finished(world); recorder.observe(world))
    takeSteps(world, recorder.stepsUntilDue(world));
  Run stepped(scene, {.every = 0.1, .atCells = {2, 4}});
  Run plain(scene, {.every = 0.1});
  const auto here = recorder.take(world), there = stepped.recorder.take(stepped.world),
             without = plain.recorder.take(plain.world);
  const auto stepsOf = [](const RunResults& results) {
    std::vector<std::uint64_t> steps;
    for (const Sample& s : results.samples) steps.push_back(s.world.step);
    return steps;
  };
  CHECK(stepsOf(here) == stepsOf(there));
  CHECK(here.samples.size() == without.samples.size() + 2);
  CHECK(std::ranges::includes(stepsOf(here), stepsOf(without)));
}

TEST_CASE("a resumed run has the samples at numbers of cells once, and none that only its stop took") {
  const RecordOptions options{.atCells = {2, 4}};
  const Scene scene = fourCells(true);
  Run whole(scene, options);
  const auto expected = whole.recorder.take(whole.world);
  for (const double stopped : {0.05, 0.13, 0.2, 0.26, 0.3}) {
    World world = makeWorld(scene);
    Recorder first(options);
    for (first.observe(world); world.clock.time < stopped; first.observe(world)) step(world);
    const RunResults earlier = first.take(world);
    Recorder second(options);
    second.resume(world, earlier);
    while (!finished(world)) step(world), second.observe(world);
    const auto results = second.take(world);
    REQUIRE(results.samples.size() == expected.samples.size());
    for (std::size_t i = 0; i < results.samples.size(); ++i)
      CHECK(results.samples[i].world == expected.samples[i].world);
  }
}

TEST_CASE("measures on demand are taken at every sample, and come back from the file as they were") {
  Reference reference;
  reference.contacts.insert({CellPath::parse("AA"), CellPath::parse("AB")});
  Run run(fourCells(true), {.every = 0.1,
                            .measures = {"contact_share", "sister_contact", "age", "contact_f1"},
                            .reference = reference,
                            .nameOf = [](const CellPath& path) { return std::optional("n" + path.text()); }});
  const RunResults results = run.recorder.take(run.world);
  REQUIRE(results.samples.size() == 5);
  CHECK(results.samples[0].more.size() == 1);  // the egg's age
  CHECK(results.samples[4].more.size() > 6);   // two measures of the world, four ages, contacts
  CHECK(results.names.size() == 7);
  CHECK(results.names.at(CellPath::parse("AB")) == "nAB");

  BegunRun stored;
  stored.store.finish(stored.id, endOf(run.world, RunStatus::done), results);
  const RunResults back = stored.store.results(stored.id);
  CHECK(back.names == results.names);
  for (std::size_t i = 0; i < results.samples.size(); ++i) {
    const auto sorted = [](std::vector<TakenMeasure> all) {
      std::ranges::sort(all, {}, [](const TakenMeasure& m) { return std::tuple(m.scope, m.name, m.a, m.b); });
      return all;
    };
    CHECK(sorted(back.samples[i].more) == sorted(results.samples[i].more));
  }
}

TEST_CASE("a sample that falls on the end is taken once") {
  Run run(fourCells(true), {.every = 0.125, .hashEvery = {}});
  CHECK(run.recorder.take(run.world).samples.size() == 4);
}

TEST_CASE("a step over several multiples gives one sample") {
  Run run(fourCells(false), {.every = 0.03125, .hashEvery = {}});  // lineage only: steps of a cycle, 0.125 each
  const RunResults results = run.recorder.take(run.world);
  CHECK(results.samples.size() == run.world.clock.step + 1);
  CHECK(results.samples.back().cells.empty());
}

TEST_CASE("after a long step the next sample is due at the next multiple") {
  World world = makeWorld(fourCells(false));
  Recorder recorder({.every = 0.25, .hashEvery = {}});
  std::vector<double> sampled;
  for (const double time : {0.0, 1.05, 1.1, 1.2, 1.25, 1.4, 1.6}) {
    world.clock.time = time;
    recorder.observe(world);
    if (recorder.sampled()) sampled.push_back(time);
  }
  CHECK(sampled == std::vector{0.0, 1.05, 1.25, 1.6});
}

TEST_CASE("state hashes at the steps that were asked for") {
  Run run(fourCells(true), {.every = {}, .hashEvery = 10});
  const RunResults results = run.recorder.take(run.world);
  REQUIRE(run.world.clock.step % 10 != 0);
  CHECK(results.chain.size() == run.world.clock.step / 10 + 2);
  CHECK(results.chain.back().step == run.world.clock.step);
  CHECK(results.chain.back().state.whole == stateHash(run.world));
  CHECK(results.chain[0].state.whole == stateHash(makeWorld(fourCells(true))));
  CHECK(results.chain[3].step == 30);
}

TEST_CASE("cells that take many steps at once are seen at the same steps, and are the same there") {
  Scene scene = fourCells(true);
  scene.mechanics->contact.reset();
  scene.mechanics->connections.reset();
  for (const double every : {0.01, 0.1, 0.25})
    for (const std::uint64_t hashEvery : {1, 7, 64}) {
      const RecordOptions options{every, hashEvery};
      Run one(scene, options);
      World world = makeWorld(scene);
      Recorder recorder(options);
      std::uint64_t looks = 1;
      for (recorder.observe(world); !finished(world); recorder.observe(world), ++looks)
        takeSteps(world, recorder.stepsUntilDue(world));
      CHECK(looks <= one.world.clock.step + 1);
      if (every == 0.25 && hashEvery == 64) CHECK(looks * 5 < one.world.clock.step);
      const RunResults single = one.recorder.take(one.world), many = recorder.take(world);
      CHECK(many.chain == single.chain);
      REQUIRE(many.samples.size() == single.samples.size());
      for (std::size_t k = 0; k < many.samples.size(); ++k) {
        CHECK(many.samples[k].world.step == single.samples[k].world.step);
        CHECK(many.samples[k].world["kinetic_energy"] == single.samples[k].world["kinetic_energy"]);
        CHECK(many.samples[k].world["volume"] == single.samples[k].world["volume"]);
      }
    }
}

TEST_CASE("a broken state is not measured, but what came before it is kept") {
  Run run(fourCells(true), {.every = 0.2, .hashEvery = {}});
  const RunResults results = run.recorder.take(run.world, true);
  CHECK(results.samples.size() == 2);
  CHECK(results.lineage.size() == 7);
  const RunEnd end = endOf(run.world, RunStatus::failed, "why");
  CHECK_FALSE(end.stateHash);
  CHECK(end.failure == "why");
}

TEST_CASE_METHOD(BegunRun, "a recorded run can be stored") {
  const bool mechanics = GENERATE(false, true);
  Run run(fourCells(mechanics), {.every = 0.125, .hashEvery = 1});
  const RunResults results = run.recorder.take(run.world);
  store.finish(id, endOf(run.world, RunStatus::done), results);
  CHECK(store.find(id).stateHash == stateHash(run.world).text());
  CHECK(store.find(id).cells == 4);
  const RunResults back = store.results(id);
  CHECK(back.lineage.size() == 7);
  CHECK(back.samples.size() == results.samples.size());
  CHECK(back.connections.size() == results.connections.size());
  CHECK(back.chain == results.chain);
  CHECK(back.timeSteps == results.timeSteps);
  for (const LineageEntry& e : back.lineage) CHECK_FALSE(back.stateTexts.at(e.state).empty());
}

namespace {

/// Returns three balls of radius 1, AA, AB and B, for putAt, which puts B beside AB at the times 1, 2, 4 and 5 and away
/// from AB otherwise. Samples at these times alone do not show the separation.
World threeBalls() {
  Scene scene;
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "test.dna");
  scene.cycle.length = 1000;
  scene.mechanics.emplace();
  scene.mechanics->mesh = makeIcosphere(1);
  scene.mechanics->physics.cell.model = CellModel::sphere;
  scene.mechanics->physics.timeStep = 0x1p-10;
  scene.mechanics->physics.drag = 5;
  scene.mechanics->contact.emplace();
  for (const double x : {0.0, 1.75, 9.0}) scene.cells.push_back({.at = Point{x, 0, 0}});
  return makeWorld(scene, {Isa::scalar, 1});
}

void putAt(World& world, double time) {
  world.clock.time = time;
  world.clock.step = static_cast<std::uint64_t>(16 * time);
  std::vector<Body> bodies;
  for (const int slot : world.bodies->slots) bodies.push_back(takeBody(*world.bodies, slot));
  const bool isBeside = time == 1 || time == 2 || time == 4 || time == 5;
  for (Point& x : bodies[2].position) x.x = isBeside ? 3.5 : 9;
  setBodies(*world.bodies, bodies);
  beginWithBodies(world);
}

std::vector<double> durationsOf(const RunResults& results, const std::string& a, const std::string& b) {
  std::vector<double> all;  // -1: no contact
  for (const Sample& s : results.samples) {
    all.push_back(-1);
    for (const TakenMeasure& m : s.more)
      if (m.name == "contact_duration" && m.a.text() == a && m.b.text() == b) all.back() = m.value;
  }
  return all;
}

}  // namespace

TEST_CASE("how long two cells have touched counts from the first of the samples in a row, also in a resumed run") {
  const RecordOptions options{.every = 1, .measures = {"contact_duration"}};
  // 1.5 lies between two samples with contact; only a stop sees 0.5 and 3.5; 3 is a sample without contact
  for (const double stopped : {-1.0, 0.5, 1.0, 1.5, 3.0, 3.5, 4.5, 5.0}) {
    CAPTURE(stopped);
    World world = threeBalls();
    Recorder recorder(options);
    for (double time = 0; time <= 5; time += 0.5) {
      putAt(world, time);
      recorder.observe(world);
      if (time != stopped) continue;
      const RunResults earlier = recorder.take(world);
      recorder = Recorder(options);
      recorder.resume(world, earlier);
    }
    const RunResults results = recorder.take(world);
    REQUIRE(results.samples.size() == 6);
    CHECK(durationsOf(results, "AA", "AB") == std::vector<double>{0, 1, 2, 3, 4, 5});
    CHECK(durationsOf(results, "AB", "B") == std::vector<double>{-1, 0, 1, -1, 0, 1});
    CHECK(durationsOf(results, "AA", "B") == std::vector<double>(6, -1));
  }
}

TEST_CASE("daughters have touched nobody before they were born") {
  Run run(fourCells(true), {.every = 0.0625, .measures = {"contact_duration"}});
  const RunResults results = run.recorder.take(run.world);
  std::map<CellPath, double> born;
  for (const LineageEntry& e : results.lineage) born[e.path] = e.born;
  double longest = 0;
  for (const Sample& s : results.samples) {
    CHECK(s.more.size() == s.contacts.size());
    for (const TakenMeasure& m : s.more) {
      CHECK(m.value >= 0);
      CHECK(m.value <= s.world.time - std::max(born[m.a], born[m.b]));
      longest = std::max(longest, m.value);
    }
  }
  CHECK(longest > 0);
}

namespace {

/// Options for many samples with surfaces: half a megabyte.
const RecordOptions much{
    .every = 0.001, .hashEvery = 1, .atCells = {2}, .measures = {"contact_duration"}, .meshes = 0.001};

void requireSame(BegunRun& one, BegunRun& other) {
  for (const TableDifference& t : one.store.compareResults(one.id, other.store, other.id)) {
    CAPTURE(t.table);
    CHECK(t.differing == 0);
    if (t.table == "mesh_sample" || t.table == "cell_hash" || t.table == "measure") CHECK(t.rows > 100);
  }
}

}  // namespace

TEST_CASE("what is recorded goes to the store while the run goes on, and is the same there") {
  BegunRun atOnce, poured;
  Run whole(fourCells(true), much);
  CHECK(whole.recorder.bytes() > 4e5);
  atOnce.store.finish(atOnce.id, endOf(whole.world, RunStatus::done), whole.recorder.take(whole.world));

  World world = makeWorld(fourCells(true));
  int times = 0;
  Recorder recorder(
      much, [&](const RunResults& records) { poured.store.record(poured.id, records), ++times; }, 1e5);
  double most = 0;
  for (recorder.observe(world); !finished(world); recorder.observe(world)) {
    step(world);
    most = std::max(most, recorder.bytes());
  }
  CHECK(times >= 2);
  CHECK(most < 1.5e5);
  CHECK(poured.store.results(poured.id).samples.empty());  // no sample is visible before the end
  poured.store.finish(poured.id, endOf(world, RunStatus::done), recorder.take(world));
  requireSame(poured, atOnce);
}

TEST_CASE("a run that is stopped and goes on takes as much memory for its records, and leaves the same") {
  BegunRun atOnce;
  Run whole(fourCells(true), much);
  const double bytes = whole.recorder.bytes();
  atOnce.store.finish(atOnce.id, endOf(whole.world, RunStatus::done), whole.recorder.take(whole.world));
  for (const bool pours : {false, true}) {
    CAPTURE(pours);
    BegunRun kept;
    World world = makeWorld(fourCells(true));
    const RecordSink sink = pours ? [&](const RunResults& r) { kept.store.record(kept.id, r); } : RecordSink();
    Recorder first(much, sink, 1e5);
    first.observe(world);
    for (const double until : {0.1, 0.2, 0.3}) {  // three checkpoints, each followed by steps that are lost
      while (world.clock.time < until) step(world), first.observe(world);
      kept.store.keepCheckpoint(kept.id, {world.clock.step, much.every, much.hashEvery, "a state"}, first.records());
    }
    kept.store = Store::openForWriting(kept.file);
    REQUIRE(kept.store.resume(exampleRecord()));
    Recorder second(much, sink, 1e5);
    kept.store.eachRecord(kept.id, [&](const RunResults& records) { second.resume(world, records); });
    while (!finished(world)) step(world), second.observe(world);
    if (!pours) CHECK(second.bytes() == bytes);
    kept.store.finish(kept.id, endOf(world, RunStatus::done), second.take(world));
    requireSame(kept, atOnce);
  }
}

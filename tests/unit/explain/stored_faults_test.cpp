// Faults in stored results: rows lost or edited in a database.

#include "catch.h"
#include "explain/explain.h"
#include "state/checkpoint.h"
#include "store/recorder.h"
#include "store/store.h"
#include "temporary_folder.h"
#include "unit/explain/runs.h"
#include "unit/store/example_run.h"

using namespace morula;

namespace {

struct StoredRunOnDisk {
  TemporaryFolder folder;
  std::filesystem::path file = folder / "run.db";
  std::string id;

  /// Runs a scene with a link of the chain every 8 steps and stores it.
  explicit StoredRunOnDisk(const Scene& scene) {
    World world = makeWorld(scene, {Isa::scalar, 1});
    Recorder recorder({.every = {}, .hashEvery = 8});
    recorder.observe(world);
    while (!finished(world)) {
      step(world);
      recorder.observe(world);
    }
    auto store = Store::openForWriting(file);
    id = store.begin(exampleRecord());
    store.finish(id, endOf(world, RunStatus::done), recorder.take(world));
  }

  std::vector<ChainLink> chainAfter(const std::string& sql) {
    if (!sql.empty()) Database(file, Database::Mode::existing, std::chrono::seconds(1)).execute(sql);
    return Store::openForReading(file).chain(id);
  }
};

Scene shortLife() {
  Scene s = scenes::life();
  s.cycle.length = 0.0625;
  return s;
}

}  // namespace

TEST_CASE("Rows that are lost, put in or edited in a database are found, with their step") {
  struct Fault {
    const char* sql;
    std::uint64_t step;
  };
  const std::vector<Fault> faults{
      {"DELETE FROM step_hash WHERE step = 64", 72},  // the first link that does not follow from its predecessor
      {"DELETE FROM step_hash WHERE step = 0", 8},
      {"DELETE FROM cell_hash WHERE step = 64 AND path = (SELECT max(path) FROM cell_hash WHERE step = 64)", 64},
      {"UPDATE cell_hash SET hash = replace(hash, substr(hash, 1, 1), 'e') WHERE step = 80 AND substr(hash, "
       "1, 1) <> 'e'",
       80},
      {"UPDATE step_hash SET lineage = clock WHERE step = 40", 40},
      {"UPDATE step_hash SET hash = state WHERE step = 48", 48},
      {"UPDATE cell_hash SET step = 57 WHERE step = 56", 56},
  };
  for (const Fault& fault : faults) {
    CAPTURE(fault.sql);
    StoredRunOnDisk stored(shortLife());
    std::uint64_t step = 0;
    REQUIRE(findBrokenLink(stored.chainAfter(""), step).empty());
    const std::string broken = findBrokenLink(stored.chainAfter(fault.sql), step);
    CHECK_THAT(broken, ContainsSubstring("at step " + std::to_string(fault.step)));
    CHECK(step == fault.step);
  }
}

TEST_CASE("A stored run tells the window and the cell; its states are gone") {
  const Scene scene = shortLife();
  StoredRunOnDisk stored(scene);
  const auto chain = stored.chainAfter("");
  REQUIRE(chain.size() > 12);
  StoredRunSource before("run", chain, chain.back().step, "");
  OwnRun same = runOf(scene, "now");
  CHECK(explain(before, same, 8).failureClass == FailureClass::none);
  OwnRun other = runOf(scene, "now", changingAt(67, [](World& w) { w.bodies->velocity[w.bodies->at(0, 3)] += 1e-9; }));
  const Explanation x = explain(before, other, 8);
  CHECK(x.failureClass == FailureClass::computation);
  CHECK(x.lastEqual == 64u);
  CHECK(x.step == 72u);
  REQUIRE(x.cell);
  CHECK_FALSE(x.difference);
  CHECK_THAT(x.text, ContainsSubstring("the same up to step 64, different at step 72"));
}

TEST_CASE("Another program tells its hashes and its state, and so step, vertex and both values are found") {
  const Scene scene = shortLife();
  constexpr std::uint64_t when = 43;
  const auto make = [scene] { return makeWorld(scene, {Isa::scalar, 1}); };
  OwnRun other =
      runOf(scene, "", changingAt(when, [](World& w) { w.bodies->position[w.bodies->at(0, 3) + blockLanes] += 1e-9; }));
  TemporaryFolder folder;
  writeText(folder / "coarse", writeHashTrace(other.hashTrace(0, 1u << 30, 64)));
  writeText(folder / "fine", writeHashTrace(other.hashTrace(0, 64, 1)));
  writeText(folder / "state", saveState(*other.stateAt(when)));
  const std::string here = folder.path().string();
  writeText(folder / "program", "#!/bin/sh\ncase \"$*\" in\n*\" --state 43\") cat " + here +
                                    "/state ;;\n*\" --every 1\") cat " + here + "/fine ;;\n*) cat " + here +
                                    "/coarse ;;\nesac\n");
  std::filesystem::permissions(folder / "program", std::filesystem::perms::owner_all);
  ProgramRun expected((folder / "program").string(), "x.yaml", make);
  OwnRun actual = runOf(scene, "now");
  const Explanation x = explain(expected, actual);
  CAPTURE(x.text);
  CHECK(x.failureClass == FailureClass::computation);
  CHECK(x.step == when);
  REQUIRE(x.difference);
  CHECK(x.difference->field == "position");
  CHECK(x.difference->vertex == 3);
  CHECK(x.difference->component == "y");

  writeText(folder / "state", "nothing that could be restored");
  ProgramRun vague((folder / "program").string(), "x.yaml", make);
  const Explanation y = explain(vague, actual);
  CHECK(y.step == when);
  CHECK_FALSE(y.difference);
  CHECK_THAT(y.text, ContainsSubstring("no vertex and values: "));
}

TEST_CASE("A trail survives its way through text, and a damaged one is refused") {
  HashTrace trace = runOf(shortLife(), "").hashTrace(0, 1u << 30, 16);
  trace.failure = "it broke: twice";
  const std::string text = writeHashTrace(trace);
  const HashTrace back = readHashTrace(text);
  CHECK(back.links == trace.links);
  CHECK(back.lastStep == trace.lastStep);
  CHECK(back.failure == trace.failure);
  CHECK_THROWS_WITH(readHashTrace(text.substr(0, text.size() / 2)), ContainsSubstring("cut short"));
  CHECK_THROWS_WITH(readHashTrace("link 0 12\nend 0\n"), ContainsSubstring("the trail is cut short, or another"));
  CHECK_THROWS_WITH(readHashTrace("{\"links\": []}"), ContainsSubstring("last_step"));
  CHECK_THROWS_WITH(readHashTrace("{\"links\": [], \"last_step\": 3e86, \"failure\": \"\"}"),
                    ContainsSubstring("needs a whole number"));
  const std::string hash = trace.links[0].state.whole.text();
  std::string wrong = text;
  wrong.replace(wrong.find(hash), 1, "x");
  CHECK_THROWS_WITH(readHashTrace(wrong), ContainsSubstring("is no hash"));
}

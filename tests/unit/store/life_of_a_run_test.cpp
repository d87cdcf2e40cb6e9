// The life of a run: running → done, failed or killed; and results when the same run is computed again.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"

using namespace morula;

namespace {

RunEnd endWith(std::uint64_t hash) {
  RunEnd end = exampleEnd();
  end.stateHash = Hash{hash, 0};
  return end;
}

}  // namespace

TEST_CASE("a run's id does not hang on how, where and under which commit it is run") {
  const RunRecord record = exampleRecord();
  const std::string id = runId(record);
  RunRecord other = record;
  other.command = "another command";
  other.threads = 7;
  other.isa = "scalar";
  other.machine.cpu = "another processor";
  other.build.gitCommit = "another commit of the same sources";
  other.documents.clear();
  REQUIRE(runId(other) == id);
}

TEST_CASE("a run's id changes with its scenario, seed and build") {
  const RunRecord record = exampleRecord();
  const std::string id = runId(record);
  RunRecord other = record;
  SECTION("scenario") { other.scenarioHash[0] = 'f'; }
  SECTION("seed") { other.seed += 1; }
  SECTION("sources") { other.build.sources += '0'; }
  SECTION("compiler") { other.build.compiler += '0'; }
  SECTION("flags") { other.build.flags += " -O0"; }
  SECTION("target") { other.build.target += '0'; }
  SECTION("a library") { other.build.libraries[0].second += '0'; }
  REQUIRE(runId(other) != id);
}

TEST_CASE_METHOD(BegunRun, "a run is in the file before its first step") {
  REQUIRE(count("run WHERE status = 'running' AND ended IS NULL AND state_hash IS NULL") == 1);
  REQUIRE(store.find(id).status == RunStatus::running);

  SECTION("done") {
    finish();
    REQUIRE(count("run WHERE status = 'done' AND ended IS NOT NULL") == 1);
  }
  SECTION("failed: what there is is kept, with the reason") {
    store.finish(
        id, {.status = RunStatus::failed, .steps = 3, .cells = 2, .time = 0.5, .failure = "step 3, cell A: volume −1"},
        exampleResults());
    REQUIRE(store.find(id).status == RunStatus::failed);
    REQUIRE(store.find(id).failure == "step 3, cell A: volume −1");
    REQUIRE(store.find(id).stateHash.empty());
    REQUIRE(store.results(id).lineage.size() == 3);
  }
  SECTION("killed") {
    store.finish(id, {.status = RunStatus::killed}, exampleResults());
    REQUIRE(store.find(id).status == RunStatus::killed);
  }
}

TEST_CASE("a process that dies leaves a run that shows as running, and a whole file") {
  TemporaryFolder folder;
  const auto file = folder / "runs.db";
  const bool midTransaction = GENERATE(false, true);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    Store store = Store::openForWriting(file);
    const std::string id = store.begin(exampleRecord());
    Database db(file, Database::Mode::existing, std::chrono::seconds(1));
    std::optional<Transaction> transaction;
    if (midTransaction) {
      db.execute("PRAGMA cache_size = 1");  // forces half of the transaction into the file
      transaction.emplace(db);
      Statement insert(db, "INSERT INTO time_step VALUES (?, ?, 0.0, 1.0)");
      for (int i = 0; i < 100'000; ++i) insert.run(id, i);
    }
    kill(getpid(), SIGKILL);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  REQUIRE(std::filesystem::exists(file.string() + "-journal") == midTransaction);

  Store store = Store::openForReading(file);
  REQUIRE(store.runs().size() == 1);
  REQUIRE(store.runs()[0].status == RunStatus::running);
  Database db(file, Database::Mode::existing, std::chrono::seconds(1));
  REQUIRE(db.integer("SELECT count(*) FROM time_step") == 0);
  REQUIRE(db.integer("SELECT count(*) FROM pragma_integrity_check WHERE integrity_check = 'ok'") == 1);

  // The run can be computed again.
  Store again = Store::openForWriting(file);
  const std::string id = again.begin(exampleRecord());
  again.finish(id, exampleEnd(), exampleResults());
  REQUIRE(again.runs().size() == 1);
  REQUIRE(again.runs()[0].status == RunStatus::done);
}

TEST_CASE_METHOD(FinishedRun, "the same run twice is one run, verified") {
  RunRecord again = exampleRecord();
  again.threads = 5;
  REQUIRE(store.begin(again) == id);
  REQUIRE(store.find(id).status == RunStatus::done);  // the first result stays until the second is complete
  REQUIRE(store.results(id).lineage.size() == 3);
  RunResults fewer = exampleResults();
  fewer.samples.clear();
  finish(fewer);
  REQUIRE(store.runs().size() == 1);
  REQUIRE(store.find(id).record.threads == 5);
  REQUIRE(store.results(id).samples.empty());
  REQUIRE(count("document") == 2);
}

TEST_CASE_METHOD(BegunRun, "the same run with another state hash is reported, and the first one kept") {
  store.finish(id, endWith(1), exampleResults());
  const std::string before = readText(file);

  Store other = Store::openForWriting(file);
  other.begin(exampleRecord());
  SECTION("another hash") {
    try {
      other.finish(id, endWith(2), {});
      FAIL("nothing was reported");
    } catch (const NondeterminismError& e) {
      REQUIRE_THAT(e.what(), ContainsSubstring("NONDETERMINISM") && ContainsSubstring(id) &&
                                 ContainsSubstring(Hash{1, 0}.text()) && ContainsSubstring(Hash{2, 0}.text()));
      REQUIRE(e.runId == id);
      REQUIRE(e.stored == Hash{1, 0}.text());
      REQUIRE(e.computed == Hash{2, 0}.text());
    }
  }
  SECTION("a failure where there was a result") {
    REQUIRE_THROWS_AS(other.finish(id, {.status = RunStatus::failed, .failure = "volume"}, {}), NondeterminismError);
  }
  SECTION("half a run says nothing") { other.finish(id, {.status = RunStatus::killed}, {}); }
  REQUIRE(readText(file) == before);
}

TEST_CASE_METHOD(BegunRun, "an attempt that did not finish is replaced, and says nothing against the next") {
  store.finish(id, {.status = RunStatus::failed, .failure = "volume"}, exampleResults());
  store.begin(exampleRecord());
  REQUIRE(store.find(id).status == RunStatus::running);
  REQUIRE(store.results(id).lineage.empty());
  store.finish(id, endWith(2), exampleResults());
  REQUIRE(store.find(id).status == RunStatus::done);
}

TEST_CASE_METHOD(FinishedRun, "a text that no run uses any more is forgotten") {
  RunRecord again = exampleRecord();
  again.documents[0].content = "# the same scenario with a comment\nmorula: 1\n";
  store.begin(again);
  finish();
  REQUIRE(store.documents(id) == again.documents);
  REQUIRE(count("document") == 2);
}

TEST_CASE_METHOD(ResultsFile, "runs with different seeds live side by side and share their documents") {
  for (std::uint64_t seed : {1u, 2u, 3u}) {
    RunRecord record = exampleRecord();
    record.seed = seed;
    store.finish(store.begin(record), endWith(seed), exampleResults());
  }
  REQUIRE(store.runs().size() == 3);
  REQUIRE(count("document") == 2);
  REQUIRE(count("cell") == 9);
}

TEST_CASE_METHOD(FinishedRun, "checks replace earlier checks of their kind") {  // one golden, one invariant
  const CheckResult better{.check = "bits", .kind = CheckKind::golden};
  store.addChecks(id, {better});
  const std::vector<CheckResult> checks = store.checks(id);
  REQUIRE(checks.size() == 2);
  REQUIRE(checks[0].kind == CheckKind::invariant);
  REQUIRE(checks[1] == better);
  REQUIRE_THROWS_AS(store.addChecks("nobody", {better}), StoreError);
}

TEST_CASE_METHOD(FinishedRun,
                 "Bullet's cells are kept beside a run's own, replaced by later ones, and go with the run") {
  Sample sample;
  sample.world.time = 0.5;
  sample.cells.resize(1);
  sample.cells[0].path = CellPath::parse("AB");
  sample.cells[0]["volume"] = 3, sample.cells[0]["area"] = 7;
  CHECK_THROWS_AS(store.putBulletSamples("none", "b1", {sample}), StoreError);
  store.putBulletSamples(id, "b3", {sample});
  sample.cells[0]["volume"] = 4;
  store.putBulletSamples(id, "b1", {sample});
  Database db = database();
  Statement row(db, "SELECT time, path, baseline, volume, area FROM bullet_sample");
  REQUIRE(row.next());
  CHECK(row.real(0) == 0.5);
  CHECK(row.text(1) == "AB");
  CHECK(row.text(2) == "b1");
  CHECK(row.real(3) == 4);
  CHECK(row.real(4) == 7);
  CHECK(!row.next());
  store.finish(store.begin(exampleRecord()), exampleEnd(), exampleResults());
  CHECK(count("bullet_sample") == 0);
}

TEST_CASE_METHOD(FinishedRun, "an end for want of memory says nothing against a run that is done") {
  RunEnd poor{.status = RunStatus::failed, .steps = 3, .failure = "there is no more memory"};
  store.begin(exampleRecord());
  CHECK_THROWS_AS(store.finish(id, poor, {}), NondeterminismError);
  poor.want = Want::memory;
  store.begin(exampleRecord());
  store.finish(id, poor, {});
  CHECK(store.find(id).status == RunStatus::done);
  CHECK(store.results(id).lineage.size() == 3);
}

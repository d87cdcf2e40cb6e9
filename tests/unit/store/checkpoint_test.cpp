// Checkpoints from which a stopped run is resumed.
#include "catch.h"
#include "database/store_error.h"
#include "example_run.h"

using namespace morula;

namespace {

Checkpoint checkpointAt(std::uint64_t step) { return {step, 0.25, 64, "state at " + std::to_string(step)}; }

RunEnd killedAt(std::uint64_t step) { return {.status = RunStatus::killed, .steps = step}; }

/// Returns samples and hashes only, as of a run that continues.
RunResults recordsUpTo(std::uint64_t step) {
  RunResults all = exampleResults(), records;
  records.stateTexts = all.stateTexts;
  for (const Sample& s : all.samples)
    if (s.world.step <= step) records.samples.push_back(s);
  for (const ChainLink& link : all.chain)
    if (link.step <= step) records.chain.push_back(link);
  return records;
}

FrameSource frames(std::size_t n, int* asked = nullptr) {
  return {n, [asked](std::size_t i) {
            if (asked) ++*asked;
            return "frame " + std::to_string(i);
          }};
}

}  // namespace

TEST_CASE_METHOD(BegunRun, "a run goes on from its last checkpoint, with what was recorded up to it, once") {
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100), frames(1));
  CHECK(count("sample") == 1);
  CHECK(count("step_hash") == 1);
  int asked = 0;
  store.keepCheckpoint(id, checkpointAt(700), recordsUpTo(700), frames(3, &asked));
  CHECK(asked == 2);                    // the first frame is stored already
  store = Store::openForWriting(file);  // as after a kill
  CHECK(count("checkpoint") == 1);
  CHECK(count("sample") == 2);
  CHECK(count("step_hash") == 2);

  const auto resumed = store.resume(exampleRecord());
  REQUIRE(resumed);
  CHECK(resumed->id == id);
  CHECK(resumed->checkpoint.step == 700);
  CHECK(resumed->checkpoint.every == 0.25);
  CHECK(resumed->checkpoint.hashEvery == 64);
  CHECK(resumed->checkpoint.state == "state at 700");
  CHECK(resumed->frames == std::vector<std::string>{"frame 0", "frame 1", "frame 2"});
  CHECK(store.results(id).samples.size() == 2);
  finish();
  CHECK(count("checkpoint") == 0);
  CHECK(count("checkpoint_frame") == 0);
  CHECK(count("sample") == 2);
  CHECK_FALSE(store.resume(exampleRecord()));
}

TEST_CASE_METHOD(BegunRun, "a killed run keeps its checkpoint, and its results are what there is") {
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100));
  RunResults results = exampleResults();
  results.checks.clear();
  store.finish(id, killedAt(700), results);
  CHECK(store.find(id).status == RunStatus::killed);
  CHECK(store.find(id).steps == 700);
  CHECK(count("cell") == 3);
  CHECK(count("document") == 2);
  REQUIRE(store.resume(exampleRecord()));
  CHECK(store.find(id).status == RunStatus::running);
  CHECK(store.find(id).ended.empty());
}

TEST_CASE_METHOD(ResultsFile, "without a checkpoint there is nothing to resume") {
  CHECK_FALSE(store.resume(exampleRecord()));
  CHECK(count("run") == 0);
  const std::string id = store.begin(exampleRecord());
  CHECK_FALSE(store.resume(exampleRecord()));
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100), frames(2));
  RunRecord other = exampleRecord();
  other.seed += 1;
  CHECK_FALSE(store.resume(other));
}

TEST_CASE_METHOD(BegunRun, "whoever begins anew loses no checkpoint until there is a later one") {
  CHECK(store.keepCheckpoint(id, checkpointAt(700), recordsUpTo(700), frames(2)));
  store.begin(exampleRecord());
  CHECK(store.checkpointStep(id) == 700u);
  CHECK(store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100), frames(1)));
  CHECK(store.checkpointStep(id) == 700u);
  store.finish(id, killedAt(100), recordsUpTo(100));
  CHECK(store.find(id).status == RunStatus::killed);
  CHECK(count("sample") == 2);
  CHECK(count("checkpoint_frame") == 2);
  store.begin(exampleRecord());
  CHECK(store.keepCheckpoint(id, checkpointAt(800), recordsUpTo(800), frames(3)));
  const auto resumed = store.resume(exampleRecord());
  REQUIRE(resumed);
  CHECK(resumed->checkpoint.step == 800);
  CHECK(resumed->frames.size() == 3);
  finish();
  CHECK_FALSE(store.checkpointStep(id));
}

TEST_CASE_METHOD(FinishedRun, "a finished run takes no checkpoint of an attempt to repeat it") {
  store.begin(exampleRecord());
  CHECK_FALSE(store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100)));
  CHECK(count("checkpoint") == 0);
  CHECK(count("sample") == 2);
  CHECK(store.find(id).status == RunStatus::done);
}

TEST_CASE_METHOD(BegunRun, "a finished run keeps the checkpoint that others go on from, and is not resumed itself") {
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100), frames(1));
  store.finish(id, exampleEnd(), exampleResults(), checkpointAt(600));
  for (int again = 0; again < 2; ++again) {
    store = Store::openForWriting(file);
    store.requireAllIntact();
    CHECK(count("checkpoint") == 1);
    CHECK(count("checkpoint_frame") == 0);
    CHECK(store.checkpointOf(id)->state == "state at 600");
    CHECK_FALSE(store.checkpointStep(id));
    CHECK_FALSE(store.resume(exampleRecord()));
    CHECK(store.find(id).status == RunStatus::done);
    store.begin(exampleRecord());  // the run once more
    store.finish(id, exampleEnd(), exampleResults(), checkpointAt(600));
  }
}

TEST_CASE_METHOD(ResultsFile, "a run that went on from another one names it, also when it was stopped and resumed") {
  RunRecord record = exampleRecord();
  record.mother = "0123456789abcdef", record.motherTime = 0.1 + 0.2;
  const std::string id = store.begin(record);
  CHECK(id == runId(exampleRecord()));  // the same computation
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100));
  store = Store::openForWriting(file);
  REQUIRE(store.resume(exampleRecord()));
  store.finish(id, exampleEnd(), exampleResults());
  CHECK(store.find(id).record.mother == record.mother);
  CHECK(store.find(id).record.motherTime == record.motherTime);
}

TEST_CASE_METHOD(BegunRun, "records that were made in another way are replaced as a whole") {
  Checkpoint without = checkpointAt(700);
  without.hashEvery.reset();
  RunResults few = recordsUpTo(700);
  few.chain.clear();
  store.keepCheckpoint(id, without, few, frames(3));
  store.keepCheckpoint(id, checkpointAt(100), recordsUpTo(100), frames(1));
  CHECK(count("checkpoint_frame") == 1);
  store.keepCheckpoint(id, checkpointAt(800), recordsUpTo(800));
  CHECK(count("step_hash") == 2);
  CHECK(count("sample") == 2);
}

TEST_CASE("a value that SQLite cannot take is refused, not stored as nothing") {
  Database db("values", Database::Mode::temporary, std::chrono::milliseconds(0));
  constexpr std::size_t tooMuch = 2'000'000'000;  // SQLite checks the length before it reads bytes
  CHECK_THROWS_AS(Statement(db, "SELECT ?").run(std::string_view("x", tooMuch)), StoreError);
}

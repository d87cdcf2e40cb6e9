// A task's file, and all files merged: stored values come back, and changes are found.
#include "study_store/task_file.h"

#include "catch.h"
#include "files/write_file.h"
#include "study_store/merged_study.h"
#include "temporary_folder.h"
#include "unit/store/example_run.h"

using namespace morula;
using namespace std::chrono_literals;

namespace {

TaskOutcome exampleTask(std::uint64_t seed = 7) {
  TaskOutcome o;
  o.task.id = seed == 7 ? "0000000000000007" : "0000000000000008";
  o.task.number = seed - 7, o.task.condition = 0, o.task.seed = seed;
  o.record = exampleRecord();
  o.record.seed = seed;
  o.end = exampleEnd();
  o.results = exampleResults();
  o.results.checks.clear();
  o.values = {{"sphericity", 0.5, 1.0 / 3}, {"sister_contact", 0.5, 1}};
  o.timing.started = "2026-01-01T00:00:00Z", o.timing.ended = "2026-01-01T00:00:01Z";
  o.timing.host = "here", o.timing.cpuSeconds = 0.25, o.timing.maxMemory = 1'000'000;
  return o;
}

std::filesystem::path write(const TemporaryFolder& folder, const TaskOutcome& outcome,
                            const std::string& name = "task.db") {
  overwriteFile(folder / name, taskFileBytes(outcome));
  return folder / name;
}

StudyTables exampleStudy() {
  StudyTables study;
  study.study = {.name = "two", .summary = "", .planId = "p", .plan = "{}", .buildId = ""};
  study.axes = {{0, "division"}};
  study.levels = {{0, 0, "longest", "{}"}};
  study.keys = {"division.plane"};
  study.conditions = {{{"longest"}, true, 2, {"longest"}}};
  study.replicates = {{0, 7, "0000000000000007"}, {0, 8, "0000000000000008"}};
  return study;
}

void merge(const TemporaryFolder& folder, const std::filesystem::path& to) {
  const StudyTables study = exampleStudy();
  MergedStudy merged(to, study);
  for (const char* name : {"7.db", "8.db"}) {
    TaskFile file(folder / name);
    merged.add(file.task(), file);
  }
  merged.finish(study, "build");
}

}  // namespace

TEST_CASE("a task's file is a database of one run, with the task beside it") {
  const TemporaryFolder folder;
  const auto file = write(folder, exampleTask());
  CHECK(looksWhole(file));
  TaskFile task(file);
  CHECK(task.whatIsWrong().empty());
  CHECK(task.task().id == "0000000000000007");
  CHECK(task.task().status == TaskStatus::done);
  CHECK(task.task().isComputed());
  CHECK(task.task().seed == 7);
  CHECK(task.run().stateHash == exampleEnd().stateHash->text());
  CHECK(task.timing().cpuSeconds == 0.25);
  CHECK(task.timing().host == "here");
  Store store = Store::openForReading(file);  // the file is an ordinary database of runs, too
  CHECK(store.results(task.run().id).lineage.size() == 3);
  Database db(file, Database::Mode::existing, 1s);
  CHECK(db.integer("SELECT count(*) FROM result WHERE value = 1.0 / 3 AND measure = 'sphericity'") == 1);
}

TEST_CASE("the hash of results is of the results, and of nothing else") {
  const auto hashOf = [](const TaskOutcome& outcome) {
    const TemporaryFolder folder;
    return TaskFile(write(folder, outcome)).task().resultHash;
  };
  const std::string hash = hashOf(exampleTask());
  TaskOutcome elsewhere = exampleTask();
  elsewhere.timing.host = "there", elsewhere.timing.cpuSeconds = 9, elsewhere.record.command = "other";
  elsewhere.record.threads = 2, elsewhere.record.machine.cpu = "other", elsewhere.task.number = 12;
  CHECK(hashOf(elsewhere) == hash);
  TaskOutcome other = exampleTask();
  other.values[0].value = std::nextafter(other.values[0].value, 1);
  CHECK(hashOf(other) != hash);
  other = exampleTask();
  other.results.samples[1].cells[0]["area"] = 3;
  CHECK(hashOf(other) != hash);
  other = exampleTask();
  other.end.steps = 701;
  CHECK(hashOf(other) != hash);
}

TEST_CASE("a file that was cut or changed is found") {
  const TemporaryFolder folder;
  const auto file = write(folder, exampleTask());
  const std::string bytes = readText(file);
  writeText(folder / "cut.db", bytes.substr(0, bytes.size() - 1024));
  CHECK_FALSE(looksWhole(folder / "cut.db"));
  writeText(folder / "empty.db", "");
  CHECK_FALSE(looksWhole(folder / "empty.db"));
  CHECK_THROWS_AS(TaskFile(folder / "empty.db"), FileError);
  CHECK_THROWS_AS(TaskFile(folder / "none.db"), FileError);
  const auto wrongAfter = [&](const std::string& sql) {
    const auto changed = folder / "changed.db";
    writeText(changed, bytes);
    Database(changed, Database::Mode::existing, 1s).execute(sql);
    return TaskFile(changed).whatIsWrong();
  };
  CHECK_THAT(wrongAfter("UPDATE result SET value = 0.25"), ContainsSubstring("the results in the file were changed"));
  CHECK_THAT(wrongAfter("UPDATE cell_sample SET x = 0"), ContainsSubstring("the results in the file were changed"));
  CHECK_THAT(wrongAfter("DELETE FROM contact"), ContainsSubstring("the results in the file were changed"));
  CHECK_THAT(wrongAfter("UPDATE run SET seed = 8"), ContainsSubstring("run_id"));
  CHECK_THAT(wrongAfter("UPDATE run SET state_hash = '00000000000000000000000000000000'"),
             ContainsSubstring("the results in the file were changed"));
  CHECK_THAT(wrongAfter("UPDATE document SET content = x'00'"), ContainsSubstring("document"));
  CHECK_THAT(wrongAfter("UPDATE task SET status = 'failed'"), ContainsSubstring("the file's task is failed"));
}

TEST_CASE("merged, the same tasks make the same bytes, and times and machines stand in timing alone") {
  const TemporaryFolder folder, later;
  write(folder, exampleTask(7), "7.db");
  write(folder, exampleTask(8), "8.db");
  merge(folder, folder / "study.db");
  for (const std::uint64_t seed : {7, 8}) {
    TaskOutcome again = exampleTask(seed);
    again.record.command = "other", again.record.threads = 2, again.record.machine.cpu = "other";
    again.timing.started = "2027-01-01T00:00:00Z";
    write(later, again, std::to_string(seed) + ".db");
  }
  merge(later, later / "study.db");
  for (const TemporaryFolder* f : {&folder, &later}) {
    Database db(*f / "study.db", Database::Mode::existing, 1s);
    CHECK(db.integer("SELECT count(*) FROM timing") == 2);
    CHECK(db.integer("SELECT count(*) FROM run WHERE started = '' AND cpu = '' AND condition_id = 0") == 2);
    CHECK(db.integer("SELECT count(*) FROM cell") == 6);
    CHECK(db.integer("SELECT count(*) FROM condition JOIN condition_key USING (condition_id) WHERE division = "
                     "'longest' AND \"division.plane\" = 'longest'") == 1);
    CHECK(db.integer("SELECT count(*) FROM pragma_foreign_key_check") == 0);
    db.execute("DELETE FROM timing");
    db.execute("VACUUM INTO '" + (*f / "plain.db").string() + "'");
  }
  CHECK(readText(folder / "plain.db") == readText(later / "plain.db"));
  Store store = Store::openForReading(folder / "study.db");
  CHECK(store.runs().size() == 2);
  CHECK(store.changedRecord(store.runs()[0].id).empty());
  store.copyRun(store.runs()[0].id, folder / "one.db");
  Database one(folder / "one.db", Database::Mode::existing, 1s);
  CHECK(one.integer("SELECT count(*) FROM run") == 1);
  CHECK(one.integer("SELECT count(*) FROM result") == 2);
}

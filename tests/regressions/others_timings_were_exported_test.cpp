// Crates and copies of one run of a study held the table `timing` of all tasks, with hosts and commands of others.
#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;

TEST_CASE("the database in a crate holds its run's rows, and nothing of other tasks") {
  const TemporaryFolder folder;
  writeWhole(folder / "two.yaml", "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {cycles: 1}\n");
  writeWhole(folder / "two.study.yaml",
             "morula-study: 1\nname: two\nbase: two.yaml\nvary:\n  length:\n    short: {cycle.length: 1}\n"
             "    long: {cycle.length: 2}\nseeds: [1]\nmeasures: [cells]\n");
  succeeds({"study", "run", folder / "two.study.yaml", "--out", folder / "out", "--quiet"});
  const std::string merged = folder / "out/study.db";
  REQUIRE(integerIn(merged, "SELECT count(*) FROM timing") == 2);
  const std::string run = [&] {
    morula::Database db = opened(merged);
    morula::Statement first(db, "SELECT run_id FROM run ORDER BY run_id LIMIT 1");
    REQUIRE(first.next());
    return first.text(0);
  }();
  succeeds({"export", merged, "--run", run, "--ro-crate", folder / "crate"});
  morula::Database copy = opened(folder / "crate/run.db");
  CHECK(copy.integer("SELECT count(*) FROM run") == 1);
  CHECK(copy.integer("SELECT count(*) FROM task") == 1);
  CHECK(copy.integer("SELECT count(*) FROM timing") == 1);
  CHECK(copy.integer("SELECT count(*) FROM timing JOIN task USING (task_id) JOIN run USING (run_id)") == 1);
  CHECK(copy.integer("SELECT count(*) FROM sqlite_schema WHERE name IN ('study', 'replicate', 'condition')") == 0);
}

// A crate and a copy of one run of a study held the table `timing` of all tasks: hosts and commands of others.
#include "catch.h"
#include "database/database.h"
#include "launch.h"

using namespace morula::test;
using morula::Database;

TEST_CASE("the database in a crate holds its run's rows, and nothing of other tasks") {
  const TemporaryFolder folder;
  writeWhole(folder / "two.yaml", "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {cycles: 1}\n");
  writeWhole(folder / "two.study.yaml",
             "morula-study: 1\nname: two\nbase: two.yaml\nvary:\n  length:\n    short: {cycle.length: 1}\n"
             "    long: {cycle.length: 2}\nseeds: [1]\nmeasures: [cells]\n");
  const auto run = launch({"study", "run", folder / "two.study.yaml", "--out", folder / "out", "--quiet"});
  INFO(run.out << run.err);
  REQUIRE(run.code == 0);
  REQUIRE(launch({"study", "merge", folder / "two.study.yaml", "--out", folder / "out", "--quiet"}).code == 0);
  std::filesystem::path merged;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    if (entry.path().filename() == "study.db") merged = entry.path();
  REQUIRE(Database(merged, Database::Mode::existing, std::chrono::seconds(1)).integer("SELECT count(*) FROM timing") ==
          2);
  const auto crate = launch({"export", merged.string(), "--ro-crate", folder / "crate"});
  INFO(crate.out << crate.err);
  REQUIRE(crate.code == 0);
  Database copy(folder / "crate/run.db", Database::Mode::existing, std::chrono::seconds(1));
  CHECK(copy.integer("SELECT count(*) FROM run") == 1);
  CHECK(copy.integer("SELECT count(*) FROM task") == 1);
  CHECK(copy.integer("SELECT count(*) FROM timing") == 1);
  CHECK(copy.integer("SELECT count(*) FROM timing JOIN task USING (task_id) JOIN run USING (run_id)") == 1);
  CHECK(copy.integer("SELECT count(*) FROM sqlite_schema WHERE name IN ('study', 'replicate', 'condition')") == 0);
}

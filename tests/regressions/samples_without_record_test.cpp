// Without `record` nothing was sampled, although the documentation said "only start and end". An organism whose cells
// had all died was stored as one without bodies. Now every run has a sample of its start and one of its end. A value is
// NULL if and only if it was not measured.
#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;

namespace {

const char* const dies =
    "morula: 1\nname: dies\ndna: |\n  START: a0\n  g1(die|a0)\nstop: {cycles: 1}\n"
    "physics:\n  mesh: {icosphere: 1}\n  shell: {sphere: 1}\n  cell: {radius: 0.9}\n";

const char* const lives = "morula: 1\nname: lives\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 2}\n";

struct RunWithoutRecord {
  TemporaryFolder folder;
  Database db;
  explicit RunWithoutRecord(const std::string& scenario) : db(runAndOpen(folder, scenario)) {}
  static Database runAndOpen(const TemporaryFolder& folder, const std::string& scenario) {
    writeWhole(folder / "scene.yaml", scenario);
    succeeds({"run", folder / "scene.yaml", "--quiet", "--no-pictures", "--db", folder / "runs.db", "--out",
              folder / "out"});
    return opened(folder / "runs.db");
  }
};

}  // namespace

TEST_CASE("a run without record has a sample of its start and of its end") {
  for (const std::string physics : {"", "physics: {mesh: {icosphere: 1}}\n"}) {
    RunWithoutRecord stored(lives + physics);
    Statement samples(stored.db, "SELECT time, volume IS NULL FROM sample ORDER BY time");
    REQUIRE(samples.next());
    CHECK(samples.real(0) == 0);
    CHECK(samples.integer(1) == physics.empty());
    REQUIRE(samples.next());
    CHECK(samples.real(0) == Approx(2));
    CHECK(!samples.next());
  }
}

TEST_CASE("an organism whose cells have all died has bodies, but none alive") {
  RunWithoutRecord stored(dies);
  Statement last(stored.db,
                 "SELECT cells, volume, kinetic_energy, shell_fill, mean_pressure IS NULL, outermost IS NULL FROM "
                 "sample ORDER BY time DESC LIMIT 1");
  REQUIRE(last.next());
  CHECK(last.integer(0) == 0);
  for (int column : {1, 2, 3}) {
    CHECK(!last.isNull(column));
    CHECK(last.real(column) == 0);
  }
  CHECK(last.integer(4) == 1);
  CHECK(last.integer(5) == 1);
}

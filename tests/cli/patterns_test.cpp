// Tests the claims of the scenarios of patterns, counted in the databases of their runs.
#include <set>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;

namespace {

/// Runs a scenario into a database, and returns the database's file.
std::string runInto(const TemporaryFolder& folder, const std::string& scenario, const Words& options = {}) {
  const std::string file = folder / "run.db";
  succeeds(joined({"run", "scenarios/patterns/" + scenario, "--no-pictures", "--db", file}, options));
  return file;
}

// [1] The share of the last contact areas between cells that both hold red, or both blue.
const std::string shareWithin =
    "WITH alive AS (SELECT path, state LIKE '%red%' AS red FROM cell WHERE fate = 'alive') "
    "SELECT sum(area * (a.red = b.red)) / sum(area) FROM contact JOIN alive a ON a.path = contact.a "
    "JOIN alive b ON b.path = contact.b WHERE time = (SELECT max(time) FROM contact)";

/// [length] The mean distance from the mean of all cells, over cells that hold red or over those that do not.
std::string distanceOf(bool red) {
  return std::string(
             "WITH last AS (SELECT s.*, cell.state LIKE '%red%' AS red FROM cell_sample s JOIN cell USING (path) ") +
         "WHERE time = (SELECT max(time) FROM cell_sample)), mid AS (SELECT avg(x) AS x, avg(y) AS y, avg(z) AS z FROM "
         "last) SELECT avg(sqrt((last.x - mid.x) * (last.x - mid.x) + (last.y - mid.y) * (last.y - mid.y) + (last.z - "
         "mid.z) * (last.z - mid.z))) FROM last, mid WHERE red = " +
         (red ? "1" : "0");
}

}  // namespace

TEST_CASE("a cyst has sixteen cells and fifteen bridges: two cells with 4, two with 3, four with 2, eight with 1") {
  const TemporaryFolder folder;
  const std::string file = runInto(folder, "cyst.yaml");
  const std::string ends =
      "(SELECT a AS path FROM connection WHERE released IS NULL UNION ALL "
      "SELECT b FROM connection WHERE released IS NULL)";
  CHECK(realIn(file, "SELECT count(*) FROM connection WHERE released IS NULL") == 15);
  for (const auto& [bridges, cells] : {std::pair{1, 8}, {2, 4}, {3, 2}, {4, 2}})
    CHECK(realIn(file, "SELECT count(*) FROM (SELECT count(*) AS n FROM " + ends +
                           " GROUP BY path) WHERE n = " + std::to_string(bridges)) == cells);
  // Cells with a bridge between them lie side by side: a cell at rest is 0.80 wide. The first and the ninth cell hold
  // four bridges each, which draw them apart a little, so that these two do not touch.
  CHECK(realIn(file,
               "SELECT count(*) FROM connection c JOIN contact k ON k.a = c.a AND k.b = c.b "
               "WHERE c.released IS NULL AND k.time = (SELECT max(time) FROM contact)") == 14);
  CHECK(realIn(file,
               "WITH l AS (SELECT * FROM cell_sample WHERE time = (SELECT max(time) FROM cell_sample)) "
               "SELECT max((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y) + (p.z - q.z) * (p.z - q.z)) "
               "FROM connection c JOIN l p ON p.path = c.a JOIN l q ON q.path = c.b WHERE released IS NULL") <
        0.9 * 0.9);
}

TEST_CASE("pairs of cells touch over areas in the order of their adhesion") {
  const TemporaryFolder folder;
  const std::string file = runInto(folder, "sticky-pairs.yaml");
  const auto area = [&](const std::string& a, const std::string& b) {
    return realIn(file, "SELECT area FROM contact WHERE time = 5 AND a = '" + a + "' AND b = '" + b + "'");
  };
  // On icosphere 3 these areas are 3.57 and 2.28 at rest. Slack cells that stick weakly are 7.4 % off on icosphere 2,
  // and by 0.9 % more at time 5.
  CHECK(area("AAA", "AAB") == Approx(3.57).epsilon(0.05));
  CHECK(area("AB", "BAA") == Approx(2.28).epsilon(0.084));
  // Cells that do not stick lie side by side without pressure.
  CHECK(realIn(file, "SELECT count(*) FROM contact WHERE time = 5") == 2);
}

TEST_CASE("tissues that differ in adhesion sort, the one that sticks more inside; equal ones do not") {
  int sorts = 0, redInside = 0, equalSorts = 0;
  for (int seed = 1; seed <= 10; ++seed) {
    const TemporaryFolder folder, control;
    const std::string number = std::to_string(seed);
    const std::string sorted = runInto(folder, "sorting.yaml", {"--seed", number});
    sorts += realIn(sorted, shareWithin) >= 0.8;
    redInside += realIn(sorted, distanceOf(true)) < realIn(sorted, distanceOf(false)) - 0.2;
    const std::string equal =
        runInto(control, "sorting.yaml", {"--seed", number, "--set", "physics.contact.adhesion=3"});
    equalSorts += realIn(equal, shareWithin) >= 0.6;
  }
  CHECK(sorts >= 9);
  CHECK(redInside >= 9);
  CHECK(equalSorts == 0);
}

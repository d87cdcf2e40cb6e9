// Comparisons with Bullet and other engines, as users ask for them.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// A scenario of one cell that swings in Bullet's integrator; the text of check.bullet follows.
const std::string one = R"(morula: 1
name: one
dna: |
  START: a0
  g1(a0|a0)
cycle: {length: 100}
stop: {time: 1}
cells: [{at: [0, 0, 0], stretch: [1.1, 1, 1]}]
physics: {time_step: 0.0078125, integrator: thesis-verlet, drag: 1, mesh: {icosphere: 1}}
record: {every: 0.5}
check: {bullet: )";

bool hasBullet(const std::string& err) { return err.find("the same in Bullet") != err.npos; }

std::int64_t count(const std::string& file, const std::string& what) {
  return integerIn(file, "SELECT count(*) FROM " + what);
}

}  // namespace

TEST_CASE("run stores what Bullet made of the same scene, says so, and draws the two side by side") {
  const TemporaryFolder folder;
  writeWhole(folder / "one.yaml", one + "{}}\n");
  const auto run = succeeds({"run", folder / "one.yaml", "--out", folder.path()});
  const std::string db = folder / "one-0/run.db";
  CHECK(count(db, "check_result WHERE kind = 'bullet' AND passed") == 1);
  if (!hasBullet(run.err)) {
    CHECK(run.out.find("bullet   not checked: this build has no Bullet") != run.out.npos);
    CHECK(count(db, "bullet_sample") == 0);
    return;
  }
  CHECK(run.out.find("all 1 pass") != run.out.npos);
  // The samples have the same cells, times and volumes.
  CHECK(count(db, "bullet_sample WHERE baseline = 'b1'") == 3);
  CHECK(count(db,
              "cell_sample c JOIN bullet_sample b USING (run_id, time, path) "
              "WHERE abs(c.volume - b.volume) < 1e-9 AND b.volume > 1") == 3);
  CHECK(std::filesystem::exists(folder / "one-0/bullet.png"));
  // A second run replaces the results of the first.
  CHECK(launch({"run", folder / "one.yaml", "--out", folder.path(), "--no-pictures"}).code == 0);
  CHECK(count(db, "bullet_sample") == 3);
  CHECK(count(db, "check_result WHERE kind = 'bullet'") == 1);
}

TEST_CASE("A run that is farther from Bullet than it may be differs, and nothing of it is lost") {
  const TemporaryFolder folder;
  writeWhole(folder / "one.yaml", one + "{positions: 1e-30}}\n");
  const auto run = launch({"run", folder / "one.yaml", "--out", folder.path(), "--json"});
  if (!hasBullet(run.err)) return;
  CHECK(run.code == 1);
  CHECK(Json::parse(run.out)["status"] == "done");
  CHECK(run.err.find("check.bullet.positions: ours ") != run.err.npos);
  CHECK(count(folder / "one-0/run.db", "check_result WHERE kind = 'bullet' AND NOT passed") == 1);
  CHECK(count(folder / "one-0/run.db", "cell_sample") == 3);
}

TEST_CASE("check --beside prints a table for people, rows for programs, and both into the reports") {
  const TemporaryFolder folder;
  const std::string file = "scenarios/hard/drag-thick.yaml";
  const auto run = succeeds({"check", file, "--beside", "thesis,b1", "--reports", folder.path()});
  CHECK(
      run.out.starts_with("| case | ours | thesis' contact law | Bullet, B1 |\n|---|---|---|---|\n"
                          "| `drag-thick` | holds | holds | "));
  CHECK(readWhole(folder / "summary.md").find(run.out) != std::string::npos);
  const auto json = Json::parse(readWhole(folder / "report.json"));
  REQUIRE(json["beside"].size() == 3);
  CHECK(json["beside"][1]["engine"] == "thesis");
  CHECK(json["beside"][1]["verdict"] == "holds");
}

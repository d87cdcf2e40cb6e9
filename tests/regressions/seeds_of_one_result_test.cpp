// Ten seeds of a scenario without random parts are one result ten times, and nothing said so. `--seed` and
// `--seeds` say it once on stderr, JSON has "seed_matters".
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// Two seeds of it, cheaply.
Launched runSeeds(const TemporaryFolder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> all{"run",         uniqueFour, "--seeds",       "1..2",  "--no-pictures",           "--out",
                               folder.path(), "--set",    "stop.cycles=2", "--set", "physics.mesh.icosphere=1"};
  all.insert(all.end(), more.begin(), more.end());
  return launch(all);
}

}  // namespace

TEST_CASE("run says once that seeds change nothing, and what would make them matter") {
  const TemporaryFolder folder;
  const auto same = runSeeds(folder, {"--json"});
  CAPTURE(same.err);
  REQUIRE(same.code == 0);
  CHECK(occurrences(same.err, "every seed gives the same result") == 1);
  CHECK(occurrences(same.err, "division.plane: random") == 1);
  const auto runs = Json::parse(same.out)["runs"];
  REQUIRE(runs.size() == 2);
  CHECK(runs[0]["seed_matters"] == false);
  CHECK(runs[0]["state_hash"] == runs[1]["state_hash"]);

  const auto random = runSeeds(folder, {"--json", "--set", "division.plane=random"});
  CAPTURE(random.err);
  REQUIRE(random.code == 0);
  CHECK(random.err.find("every seed") == std::string::npos);
  const auto differing = Json::parse(random.out)["runs"];
  CHECK(differing[0]["seed_matters"] == true);
  CHECK(differing[0]["state_hash"] != differing[1]["state_hash"]);
}

TEST_CASE("a run that was not asked for a seed, or asked to be quiet, says nothing of seeds") {
  const TemporaryFolder folder;
  CHECK(runSeeds(folder, {"--quiet"}).err.empty());
  CHECK(launch({"run", uniqueFour, "--dry-run"}).err.empty());
  CHECK(occurrences(launch({"run", uniqueFour, "--dry-run", "--seed", "7"}).err, "every seed") == 1);
}

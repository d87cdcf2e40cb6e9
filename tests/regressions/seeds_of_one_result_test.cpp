// Ten seeds of a scenario without random parts give one result ten times, which nothing said. Now `--seed` and
// `--seeds` say it once on stderr, and JSON has "seed_matters".
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// Runs two seeds of a quick scenario.
Launched runSeeds(const Words& more) {
  const TemporaryFolder folder;
  const Words words{"run",         uniqueFour, "--seeds",       "1..2",  "--no-pictures",           "--out",
                    folder.path(), "--set",    "stop.cycles=2", "--set", "physics.mesh.icosphere=1"};
  return succeeds(joined(words, more));
}

}  // namespace

TEST_CASE("run says once that seeds change nothing, and what would make them matter") {
  const auto same = runSeeds({"--json"});
  CAPTURE(same.err);
  CHECK(occurrences(same.err, "every seed gives the same result") == 1);
  CHECK(occurrences(same.err, "division.plane: random") == 1);
  const auto runs = Json::parse(same.out)["runs"];
  REQUIRE(runs.size() == 2);
  CHECK(runs[0]["seed_matters"] == false);
  CHECK(runs[0]["state_hash"] == runs[1]["state_hash"]);

  const auto random = runSeeds({"--json", "--set", "division.plane=random"});
  CHECK(random.err.find("every seed") == std::string::npos);
  const auto differing = Json::parse(random.out)["runs"];
  CHECK(differing[0]["seed_matters"] == true);
  CHECK(differing[0]["state_hash"] != differing[1]["state_hash"]);
}

TEST_CASE("a run that was not asked for a seed, or asked to be quiet, says nothing of seeds") {
  CHECK(runSeeds({"--quiet"}).err.empty());
  CHECK(launch({"run", uniqueFour, "--dry-run"}).err.empty());
  CHECK(occurrences(launch({"run", uniqueFour, "--dry-run", "--seed", "7"}).err, "every seed") == 1);
}

// The effects of a scenario's own `check` on the verbs.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

/// A scenario of two cells that fly at each other; the text of `check` follows.
const std::string two = R"(morula: 1
name: two
summary: Two cells
dna: |
  START: a0
  g1(a0|a0)
stop: {time: 0.25}
cells:
  - {at: [-1.5, 0, 0], velocity: [2, 0, 0]}
  - {at: [1.5, 0, 0], velocity: [-2, 0, 0]}
physics: {mesh: {icosphere: 1}, contact: {}}
)";

const std::string inside = "check: {fails: [step, inside out, physics.pressure.constant]}\n";

const std::string collapses = replaced(two, "contact: {}", "pressure: {constant: 0, outside: 50}");
const std::string refusedScene = replaced(two, "contact: {}", "time_step: 1");

Launched with(const char* verb, const TemporaryFolder& folder, const std::string& text) {
  writeWhole(folder / "two.yaml", text);
  const Words ofRuns{"--out", folder.path(), "--no-pictures"};
  return launch(joined({verb, folder / "two.yaml", "--json"}, std::string(verb) == "run" ? ofRuns : Words{}));
}

}  // namespace

TEST_CASE("run holds a scenario's invariants also where there is no golden file") {
  const TemporaryFolder folder;
  const auto good = with("run", folder, two + "check: {volume: [0.9, 1.3], momentum: 1e-9, end-overlap: 0.01}\n");
  INFO(good.err);
  CHECK(good.code == 0);
  CHECK(Json::parse(good.out)["checked"] == true);
  const auto bad = with("run", folder, two + "check: {energy: 3.5}\n");
  CHECK(bad.code == 1);
  CHECK(bad.err.find("check.energy: ") != std::string::npos);
  CHECK(bad.err.find("expected at most 3.5 at step 0") != std::string::npos);
  const auto none = with("run", folder, two);
  CHECK(Json::parse(none.out)["checked"].is_null());
}

TEST_CASE("check: a run that must stop passes if it stops, and says why, during the run or before it") {
  const TemporaryFolder folder;
  for (const auto& text :
       {collapses + inside, refusedScene + "check: {fails: [physics.time_step, longer than the whole run]}\n"}) {
    const auto run = with("check", folder, text);
    INFO(run.err);
    CHECK(run.code == 0);
    const auto results = Json::parse(run.out)["results"];
    REQUIRE(results.size() == 1);
    CHECK(results[0]["check"] == "fails");
    CHECK(results[0]["kind"] == "invariant");
    CHECK(results[0]["passed"] == true);
  }
}

TEST_CASE("check: a run that must stop and does not, or for another reason, differs") {
  const TemporaryFolder folder;
  const auto well = with("check", folder, two + inside);
  CHECK(well.code == 1);
  CHECK(well.err.find("the run ended well") != std::string::npos);
  const auto other = with("check", folder, collapses + "check: {fails: [friction]}\n");
  CHECK(other.code == 1);
  CHECK(other.err.find("missing: friction") != std::string::npos);
  CHECK(with("check", folder, refusedScene + "check: {fails: [friction]}\n").code == 1);
  CHECK(with("check", folder, refusedScene).code == 3);
}

TEST_CASE("run: what must stop still ends with the code of its failure, and its check is stored") {
  const TemporaryFolder folder;
  const auto run = with("run", folder, collapses + inside);
  CHECK(run.code == 4);
  CHECK(Json::parse(run.out)["checked"] == true);
  CHECK(with("run", folder, refusedScene + inside).code == 3);
}

TEST_CASE("review accepts nothing that breaks what the scenario demands") {
  const TemporaryFolder folder;
  writeWhole(folder / "two.yaml", two + "check: {energy: 3.5}\n");
  const auto run = endsWith(3, {"review", folder / "two.yaml", "--accept", "--by", "me", "--why", "because"},
                            {{"CI", ""}, {"GITHUB_ACTIONS", ""}});
  CHECK(run.err.find("nothing accepted") != std::string::npos);
}

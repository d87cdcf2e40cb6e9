// morula study plan; and init, schema and validate for studies.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// Writes a study and its scenario by `morula init`, without `variation`, so that seeds change only random planes.
/// Returns the study's file.
std::string starterIn(const TemporaryFolder& folder) {
  const std::string study = folder / "first.study.yaml", scenario = folder / "organism.yaml";
  CHECK(launch({"init", scenario}).code == 0);
  std::string text = readWhole(scenario);
  const auto line = text.find("\nvariation: ");
  REQUIRE(line != text.npos);
  writeWhole(scenario, text.erase(line, text.find('\n', line + 1) - line));
  CHECK(launch({"init", "--study", "first", "--base", "organism.yaml", study}).code == 0);
  return study;
}

}  // namespace

TEST_CASE("A study that init writes is valid, and its plan is told, written once, and the same again") {
  const TemporaryFolder folder;
  const std::string study = starterIn(folder), to = folder / "results";
  CHECK(succeeds({"validate", study}).out == study + ": fine; conditions: 4, distinct runs: 22\n");

  const auto dry = succeeds({"study", "plan", study, "--out", to, "--dry-run"});
  for (const char* text : {"4 conditions × 10 seeds = 40 replicates: 22 distinct scenes, each run once",
                           "2 conditions without random parts, which no seed changes",
                           "division: longest, connections: none", "of CPU time", "on disk"}) {
    CAPTURE(text);
    CHECK(dry.out.find(text) != std::string::npos);
  }
  CHECK_FALSE(fs::exists(to));

  CHECK_THAT(succeeds({"study", "plan", study, "--out", to}).err, ContainsSubstring("wrote " + to + "/plan.json"));
  const std::string plan = readWhole(to + "/plan.json");
  succeeds({"study", "plan", study, "--out", to, "--no-predict"});
  CHECK(readWhole(to + "/plan.json") == plan);

  writeWhole(study, replaced(readWhole(study), "1..10", "1..11"));
  CHECK_THAT(endsWith(3, {"study", "plan", study, "--out", to}).err, ContainsSubstring("another plan"));
  CHECK(readWhole(to + "/plan.json") == plan);
}

TEST_CASE("A scenario and a study that init writes run without a warning, and each seed makes a difference") {
  const TemporaryFolder folder;
  REQUIRE(launch({"init", folder / "my-organism.yaml"}).code == 0);
  REQUIRE(launch({"init", "--study", "first", folder / "first.study.yaml"}).code == 0);
  const auto run =
      succeeds({"run", folder / "my-organism.yaml", "--no-pictures", "--quiet", "--out", folder / "results"});
  CHECK(run.err.empty());
  CHECK(run.out.find("warning") == run.out.npos);
  CHECK(run.out.find("sane     yes") != run.out.npos);
  CHECK(launch({"validate", folder / "first.study.yaml"}).out ==
        std::string(folder / "first.study.yaml") + ": fine; conditions: 4, distinct runs: 40\n");
}

TEST_CASE("The plan as JSON agrees with the plan's file") {
  const TemporaryFolder folder;
  const std::string study = starterIn(folder), to = folder / "results";
  const json told = jsonOf({"study", "plan", study, "--out", to}), file = json::parse(readWhole(to + "/plan.json"));
  CHECK(told.at("plan") == file.at("id"));
  CHECK(told.at("distinct_runs") == file.at("tasks").size());
  CHECK(told.at("replicates") == file.at("replicates").size());
  CHECK(told.at("without_seeds") == json::array({0, 1}));
  REQUIRE(told.at("tasks").size() == file.at("tasks").size());
  for (std::size_t i = 0; i < told.at("tasks").size(); ++i)
    CHECK(told["tasks"][i]["task_id"] == file["tasks"][i]["id"]);
  CHECK(told.at("conditions")[3].at("labels") == json{{"division", "random"}, {"connections", "both"}});
  CHECK(told.at("cost").at("cpu_seconds").get<double>() > 0);
}

TEST_CASE("validate tells all mistakes of bad studies as their files say") {
  Words files;
  std::string expected;
  for (const auto& entry : fs::directory_iterator("tests/bad_studies"))
    if (entry.path().string().ends_with(".study.yaml")) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 25);
  for (const auto& file : files) expected += readWhole(fs::path(file).replace_extension(".expected").string());
  const auto run = launch(joined({"validate"}, files));
  CHECK(run.code == 3);
  CHECK(run.out.empty());
  CHECK(run.err == expected);
}

TEST_CASE("A study is not taken for a scenario, and verbs below study have their own help") {
  const TemporaryFolder folder;
  const std::string study = starterIn(folder);
  refuses({"run", study}, 3, "the file is a study");
  CHECK_THAT(succeeds({"study", "plan", "--help"}).out, ContainsSubstring("Usage: morula study plan [OPTIONS] study"));
  CHECK(launch({"study", "--help"}).out.find("plan") != std::string::npos);
}

TEST_CASE("The schema of studies is JSON, and the table for people is the one that is shipped") {
  CHECK(json::parse(succeeds({"schema", "--study"}).out).at("title") == "Morula study");
  CHECK(launch({"schema", "--study", "--markdown"}).out == readWhole("scenarios/STUDIES.md"));
}

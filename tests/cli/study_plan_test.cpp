// morula study plan, and what init, schema and validate say of studies.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A study and its scenario, as `morula init` writes them; without `variation`, so that seeds change random planes alone.
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
  const auto valid = launch({"validate", study});
  CHECK(valid.code == 0);
  CHECK(valid.out == study + ": fine; conditions: 4, distinct runs: 22\n");

  const auto dry = launch({"study", "plan", study, "--out", to, "--dry-run"});
  CHECK(dry.code == 0);
  for (const char* text : {"4 conditions × 10 seeds = 40 replicates: 22 distinct scenes, each run once",
                           "2 conditions without anything that a seed changes", "division: longest, connections: none",
                           "of CPU time", "on disk"}) {
    CAPTURE(text);
    CHECK(dry.out.find(text) != std::string::npos);
  }
  CHECK_FALSE(fs::exists(to));

  const auto made = launch({"study", "plan", study, "--out", to});
  CHECK(made.code == 0);
  CHECK(made.err.find("wrote " + to + "/plan.json") != std::string::npos);
  const std::string plan = readWhole(to + "/plan.json");
  const auto again = launch({"study", "plan", study, "--out", to, "--no-predict"});
  CHECK(again.code == 0);
  CHECK(readWhole(to + "/plan.json") == plan);

  std::string changed = readWhole(study);
  changed.replace(changed.find("1..10"), 5, "1..11");
  writeWhole(study, changed);
  const auto other = launch({"study", "plan", study, "--out", to});
  CHECK(other.code == 3);
  CHECK(other.err.find("another plan") != std::string::npos);
  CHECK(readWhole(to + "/plan.json") == plan);
}

TEST_CASE("A scenario and a study that init writes run without a warning, and each seed makes a difference") {
  const TemporaryFolder folder;
  REQUIRE(launch({"init", folder / "my-organism.yaml"}).code == 0);
  REQUIRE(launch({"init", "--study", "first", folder / "first.study.yaml"}).code == 0);
  const auto run =
      launch({"run", folder / "my-organism.yaml", "--no-pictures", "--quiet", "--out", folder / "results"});
  CHECK(run.code == 0);
  CHECK(run.err.empty());
  CHECK(run.out.find("warning") == run.out.npos);
  CHECK(run.out.find("sane     yes") != run.out.npos);
  CHECK(launch({"validate", folder / "first.study.yaml"}).out ==
        std::string(folder / "first.study.yaml") + ": fine; conditions: 4, distinct runs: 40\n");
}

TEST_CASE("The plan as JSON agrees with the plan's file") {
  const TemporaryFolder folder;
  const std::string study = starterIn(folder), to = folder / "results";
  const auto run = launch({"study", "plan", study, "--out", to, "--json"});
  REQUIRE(run.code == 0);
  const json told = json::parse(run.out), file = json::parse(readWhole(to + "/plan.json"));
  CHECK(told.at("morula") == 1);
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
  std::vector<std::string> files, arguments{"validate"};
  std::string expected;
  for (const auto& entry : fs::directory_iterator("tests/bad_studies"))
    if (entry.path().string().ends_with(".study.yaml")) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  REQUIRE(files.size() >= 25);
  for (const auto& file : files) {
    arguments.push_back(file);
    expected += readWhole(fs::path(file).replace_extension(".expected").string());
  }
  const auto run = launch(arguments);
  CHECK(run.code == 3);
  CHECK(run.out.empty());
  CHECK(run.err == expected);
}

TEST_CASE("Studies and scenarios are not taken for each other, and verbs below study are spelt out") {
  const TemporaryFolder folder;
  const std::string study = starterIn(folder);
  const auto run = launch({"run", study});
  CHECK(run.code == 3);
  CHECK(run.err.find("the file is a study") != std::string::npos);
  const auto plan = launch({"study", "plan", folder / "organism.yaml"});
  CHECK(plan.code == 3);
  CHECK(plan.err.find("the file is a scenario") != std::string::npos);
  for (const auto& [arguments, text] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"study"}, "morula: study: no verb; one of plan"},
           {{"study", "plann", study}, "morula: study: unknown verb 'plann'; did you mean plan?"},
           {{"study", study}, "did you mean morula study plan " + study + "?"},
           {{"study", "plan", study, "--dry-ru"},
            "morula: study plan: '--dry-ru' is not expected; did you mean --dry-run?"},
           {{"study", "plan"}, "morula: study plan: study is required"},
           {{"validate", "--seed", "3", study}, "is a study"},
           {{"init", "--base", "a.yaml"}, "--base: only with --study"}}) {
    CAPTURE(text);
    const auto wrong = launch(arguments);
    CHECK(wrong.code == 2);
    CHECK(wrong.err.find(text) != std::string::npos);
  }
  const auto help = launch({"study", "plan", "--help"});
  CHECK(help.code == 0);
  CHECK(help.out.find("Usage: study plan [OPTIONS] study") != std::string::npos);
  CHECK(launch({"study", "--help"}).out.find("plan") != std::string::npos);
}

TEST_CASE("The schema of studies is JSON, and the table for people is the one that is shipped") {
  const auto schema = launch({"schema", "--study"});
  CHECK(schema.code == 0);
  CHECK(json::parse(schema.out).at("title") == "Morula study");
  CHECK(launch({"schema", "--study", "--markdown"}).out == readWhole("scenarios/STUDIES.md"));
}

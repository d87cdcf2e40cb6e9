// `morula check` as a step of continuous integration.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

TEST_CASE("check --reports leaves what other tools read") {
  const TemporaryFolder folder;
  succeeds({"check", "scenarios/thesis/elegans-1024.yaml",  // a lineage, which takes no time
            "--reports", folder / "new/reports", "--quiet"});
  CHECK_THAT(readWhole(folder / "new/reports/junit.xml"), ContainsSubstring("failures=\"0\""));
  const auto report = nlohmann::json::parse(readWhole(folder / "new/reports/report.json"));
  CHECK(report["morula"] == 1);
  CHECK(report["results"].size() > 3);
  CHECK_THAT(readWhole(folder / "new/reports/summary.md"), ContainsSubstring("thesis/elegans-1024 | "));
}

TEST_CASE("Within a workflow, what differs is annotated and stands on its page") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "alone.yaml";
  writeWhole(scenario, readWhole(MORULA_SOURCE_DIR "/tests/cost/plain.yaml"));
  writeWhole(folder / "page.md", "before\n");
  const Environment workflow{{"GITHUB_ACTIONS", "true"}, {"GITHUB_STEP_SUMMARY", folder / "page.md"}};
  const auto run = launch({"check", scenario}, workflow);
  CHECK(run.code == 1);
  CHECK_THAT(run.out, ContainsSubstring("::error title=SETUP%3A "));
  CHECK_THAT(readWhole(folder / "page.md"), ContainsSubstring("before\n### morula check"));
  CHECK_THAT(launch({"check", scenario}).out, !ContainsSubstring("::error"));

  // With --json the output stays JSON.
  const auto json = launch({"check", scenario, "--json"}, workflow);
  CHECK(nlohmann::json::parse(json.out)["results"][0]["class"] == "SETUP");
}

TEST_CASE("A golden that somebody has edited is one failed check, and others go on") {
  const TemporaryFolder folder;
  const std::string text = "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(a0|a0)\nstop: {cycles: 2}\n";
  for (const auto* name : {"a", "b"}) {
    const std::string scenario = folder / (std::string(name) + ".yaml");
    writeWhole(scenario, text);
    accept(scenario);
  }
  writeWhole(folder / "a.golden", replaced(readWhole(folder / "a.golden"), "count cells 1", "count cells 2"));
  const auto run = launch({"check", folder / "a.yaml", folder / "b.yaml", "--json"});
  CHECK(run.code == 3);
  const auto results = nlohmann::json::parse(run.out)["results"];
  CHECK(results[0]["class"] == "INPUT_CHANGED");
  CHECK(results.size() > 2);  // b was checked too
  CHECK(results.back()["passed"] == true);
  CHECK_THAT(run.err, ContainsSubstring("a.golden:"));
}

// morula report: what stands on the page, the same bytes every time, and what it refuses.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "catch.h"
#include "launch.h"

using namespace morula::test;

namespace {

const std::string summarisedScene = R"(morula: 1
name: small
summary: two <b>cells</b>
dna: |
  START: a0
  g1(divide|a0)
stop: {time: 1.5}
physics: {mesh: {icosphere: 1}, contact: {}}
)";

struct RunToReport {
  TemporaryFolder folder;
  std::string database = folder / "run.db", page = folder / "page.html";
  RunToReport() { writeWhole(folder / "small.yaml", summarisedScene); }
  void run(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", folder / "small.yaml", "--db", database, "--no-pictures", "--quiet"});
    const auto launched = launch(more);
    INFO(launched.err);
    REQUIRE(launched.code == 0);
  }
  std::string report(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"report", database, "-o", page});
    const auto launched = launch(more);
    INFO(launched.err);
    REQUIRE(launched.code == 0);
    CHECK(launched.out == page + "\n");
    return readWhole(page);
  }
};

}  // namespace

TEST_CASE("A page of a run: verdict first, where it comes from, and the same bytes again") {
  RunToReport stored;
  stored.run();
  const std::string page = stored.report();
  CHECK(page == stored.report());
  CHECK(page.starts_with("<!DOCTYPE html>\n<!-- Morula report -->\n"));
  CHECK(page.find("id=\"verdict\"") < page.find("id=\"explorer\""));
  CHECK_THAT(page, ContainsSubstring("id=\"provenance\""));
  CHECK_THAT(page, ContainsSubstring("two &lt;b&gt;cells&lt;/b&gt;"));
  CHECK_THAT(page, ContainsSubstring("The run is done: 2 cells at time 1.5 after"));
  CHECK_THAT(page, ContainsSubstring("download=\"lineage.nwk\""));
  CHECK_THAT(page, ContainsSubstring("./morula replay"));
}

TEST_CASE("Nothing is run again when no shapes are asked for, and little room is kept to") {
  RunToReport stored;
  stored.run();
  CHECK_THAT(stored.report({"--frames", "0"}), !ContainsSubstring("the organism at the end"));
  CHECK_THAT(stored.report({"--frames", "3"}), ContainsSubstring("the organism at the end"));
}

TEST_CASE("Seeds that change nothing are no replicates, and the page says so") {
  RunToReport stored;
  stored.run({"--seeds", "1..3"});
  const std::string page = stored.report({"--frames", "2"});
  CHECK_THAT(page, ContainsSubstring("3 seeds of small gave one and the same result, bit for bit"));
  CHECK_THAT(page, ContainsSubstring("The scenarios are the same but for their seeds."));
}

TEST_CASE("Two runs of one scenario are called by what they differ in, and the page says what became of it") {
  RunToReport stored;
  stored.run();
  stored.run({"--set", "physics.drag=2"});
  const std::string page = stored.report({"--frames", "2"});
  CHECK_THAT(page, ContainsSubstring("<h1>small, 2 runs</h1>"));
  // The one that began first is told of first; two that began in one second are told by their ids.
  CHECK_THAT(page, ContainsSubstring("<h3>physics.drag 0</h3>") || ContainsSubstring("<h3>physics.drag 2</h3>"));
  CHECK_THAT(page, ContainsSubstring("Beside physics.drag "));
  CHECK_THAT(page, ContainsSubstring("radii of the egg"));
  CHECK_THAT(page, ContainsSubstring("The lineage is the same in all runs."));
}

TEST_CASE("A run that failed says why, first of all") {
  RunToReport stored;
  // Without pressure enough the shell turns the egg inside out in some twenty steps.
  REQUIRE(launch({"run", "scenarios/thesis/unique-four.yaml", "--db", stored.database, "--out", stored.folder.path(),
                  "--quiet", "--set", "physics.pressure.constant=3"})
              .code == 4);
  const std::string page = stored.report();
  CHECK_THAT(page, ContainsSubstring("The run failed: "));
  CHECK_THAT(page, ContainsSubstring("There are faults."));
}

TEST_CASE("A check leaves a page of what differs") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "small.yaml";
  writeWhole(scenario, summarisedScene);
  REQUIRE(launch({"review", scenario, "--accept", "--by", "tests", "--why", "the first one"}, {{"CI", ""}}).code == 0);
  REQUIRE(launch({"check", scenario, "--reports", folder / "out"}).code == 0);
  CHECK_THAT(readWhole(folder / "out/report.html"), ContainsSubstring("1 of 1 scenario passes"));
  std::string other = summarisedScene;
  writeWhole(scenario, other.replace(other.find("stop: {time: 1.5}"), 17, "stop: {time: 1.6}"));
  REQUIRE(launch({"check", scenario, "--reports", folder / "out"}).code == 1);
  const std::string page = readWhole(folder / "out/report.html");
  CHECK_THAT(page, ContainsSubstring("1 of 1 scenario differs"));
  CHECK_THAT(page, ContainsSubstring("stop.time: 1.5 → 1.6"));
  CHECK_THAT(page, ContainsSubstring("same lineage") || ContainsSubstring("lineage: "));
  CHECK_THAT(page, ContainsSubstring("./morula explain"));
  const auto again = launch({"report", folder / "out", "-o", folder / "again.html"});
  INFO(again.err);
  CHECK(again.code == 0);
}

TEST_CASE("A page of a study: its verdicts first, then every value and its runs") {
  RunToReport stored;
  writeWhole(stored.folder / "two.study.yaml",
             "morula-study: 1\nname: two\nbase: small.yaml\nvary:\n  drag:\n    less: {physics.drag: 1}\n"
             "    more: {physics.drag: 4}\nseeds: 1..2\nmeasures: [sphericity]\nkeep: {pictures: first-seed}\n");
  const auto ran = launch(
      {"study", "run", stored.folder / "two.study.yaml", "--out", stored.folder / "study", "--no-predict", "--quiet"});
  INFO(ran.err);
  REQUIRE(ran.code == 0);
  const auto launched = launch({"report", stored.folder / "study", "-o", stored.page, "--frames", "2"});
  INFO(launched.err);
  REQUIRE(launched.code == 0);
  const std::string page = readWhole(stored.page);
  CHECK_THAT(page, ContainsSubstring("2 of 2 distinct runs are done: 2 conditions, 2 seeds."));
  CHECK_THAT(page, ContainsSubstring("Every run is done, and sane"));
  CHECK_THAT(page,
             ContainsSubstring("2 runs have divisions with an ambiguous axis, under <b>less</b> and <b>more</b>"));
  CHECK_THAT(page, ContainsSubstring("Seeds change nothing under <b>less</b>"));
  CHECK(page.find("What the study finds") < page.find("id=\"explorer\""));
  CHECK_THAT(page, ContainsSubstring("less, seed 1"));
  CHECK_THAT(page, ContainsSubstring("id=\"provenance\""));
  CHECK_THAT(page, ContainsSubstring("the pictures that the study keeps in"));
  // Not all runs: those that are here are said, and the others found by their names.
  const auto few =
      launch({"report", stored.folder / "study", "-o", stored.page, "--frames", "2", "--run", "more, seed 1"});
  INFO(few.err);
  REQUIRE(few.code == 0);
  CHECK_THAT(readWhole(stored.page), ContainsSubstring("1 of 2 runs are here, first the conditions"));
  CHECK_THAT(readWhole(stored.page), !ContainsSubstring("less, seed 1"));
  refuses({"report", stored.folder / "study", "-o", stored.page, "--run", "more, seed 9"}, 6, "more, seed 9");
}

TEST_CASE("Any condition and seed of a study can be explored, as many as asked for and as fit") {
  RunToReport stored;
  writeWhole(stored.folder / "two.study.yaml",
             "morula-study: 1\nname: two\nbase: small.yaml\nvary:\n  drag:\n    little: {physics.drag: 1}\n"
             "    some: {physics.drag: 1.1}\n    much: {physics.drag: 9}\nseeds: 1..3\nmeasures: [sphericity]\n");
  std::string scenario = readWhole(stored.folder / "small.yaml");
  writeWhole(stored.folder / "small.yaml", scenario + "variation: {share: 0.05}\n");
  const auto ran = launch(
      {"study", "run", stored.folder / "two.study.yaml", "--out", stored.folder / "study", "--no-predict", "--quiet"});
  INFO(ran.err);
  REQUIRE(ran.code == 0);
  const auto titles = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"report", stored.folder / "study", "-o", stored.page, "--frames", "3"};
    words.insert(words.end(), options.begin(), options.end());
    const auto launched = launch(words);
    INFO(launched.err);
    REQUIRE(launched.code == 0);
    const std::string page = readWhole(stored.page);
    std::vector<std::string> found;
    const std::string before = "\"title\":\"";
    for (auto at = page.find(before); at != page.npos; at = page.find(before, at + 1))
      found.push_back(page.substr(at + before.size(), page.find('"', at + before.size()) - at - before.size()));
    return found;
  };
  const auto all = titles({});
  if (all.empty()) return;  // a page without the explorer, where there is no Node.js
  CHECK(all.size() == 9);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == 9);
  const std::set<std::string> first(all.begin(), all.begin() + 2);
  CHECK(first.contains("much, seed 1"));  // beside little or some, which hardly differ
  CHECK(titles({"--explore", "5"}).size() == 5);
  CHECK(titles({"--size-limit", "20k"}).size() < 9);
}

TEST_CASE("What report refuses, and why") {
  RunToReport stored;
  stored.run();
  refuses({"report"}, 2, "what");
  refuses({"report", stored.folder / "none.db"}, 6, "no such file or folder");
  refuses({"report", stored.folder / "small.yaml"}, 2, "is a scenario; report needs a database");
  refuses({"report", stored.database, "-o", stored.folder / "page.pdf"}, 2, "does not end in .html");
  refuses({"report", stored.database, "--frames", "-1"}, 2, "--frames");
  refuses({"report", stored.database, "--run", "ffff"}, 6, "ffff");
  writeWhole(stored.folder / "mine.html", "<p>by hand</p>");
  refuses({"report", stored.database, "-o", stored.folder / "mine.html"}, 6, "mine.html");
  const TemporaryFolder empty;
  refuses({"report", empty.path()}, 2, "no database");
}

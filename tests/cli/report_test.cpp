// morula report: the contents of pages, equal bytes for equal input, and refusals.
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
  void run(const Words& more = {}) {
    succeeds(joined({"run", folder / "small.yaml", "--db", database, "--no-pictures", "--quiet"}, more));
  }
  std::string report(const Words& more = {}) { return reportOf(database, more); }
  std::string reportOf(const std::string& what, const Words& more) {
    CHECK(succeeds(joined({"report", what, "-o", page}, more)).out == page + "\n");
    return readWhole(page);
  }
  /// Runs the study in a folder and returns the folder.
  std::string runStudy(const std::string& text) {
    writeWhole(folder / "two.study.yaml", text);
    succeeds({"study", "run", folder / "two.study.yaml", "--out", folder / "study", "--no-predict", "--quiet"});
    return folder / "study";
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
  CHECK_THAT(page, ContainsSubstring("<code>morula replay"));
}

TEST_CASE("A page of very many cells draws some of their curves, and no edges of spheres") {
  RunToReport stored;
  writeWhole(stored.folder / "small.yaml",
             "morula: 1\nname: many\ndna: |\n  START: n0\n  n{n}(n{n+1}|n{n}) for n in 0..8\n"
             "  d{n}(divide|n{n}) for n in 0..8\nstop: {cycles: 10}\nrecord: {every: 0.5}\n"
             "physics: {integrator: quasi-static, cell: {model: sphere, radius: 0.9}, shell: {sphere: 1}, contact: {}}\n"
             "division: {plane: random}\n");
  stored.run();
  const std::string page = stored.report({"--frames", "4"});
  CHECK_THAT(page, ContainsSubstring("512 cells at time 10"));
  CHECK_THAT(page, ContainsSubstring(": each cell, 400 of "));
  CHECK_THAT(page, ContainsSubstring("alt=\"the organism at time 10"));
  CHECK_THAT(page, !ContainsSubstring("alt=\"the organism as meshes"));
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
  CHECK_THAT(page, ContainsSubstring("3 seeds of small gave the same result, bit for bit"));
  CHECK_THAT(page, ContainsSubstring("The scenarios differ only in their seeds."));
}

TEST_CASE("Two runs of one scenario are called by what they differ in, and the page says what became of it") {
  RunToReport stored;
  stored.run();
  stored.run({"--set", "physics.drag=2"});
  const std::string page = stored.report({"--frames", "2"});
  CHECK_THAT(page, ContainsSubstring("<h1>small, 2 runs</h1>"));
  // The run that began first comes first; runs of one second are sorted by their ids.
  CHECK_THAT(page, ContainsSubstring("<h3>physics.drag 0</h3>") || ContainsSubstring("<h3>physics.drag 2</h3>"));
  CHECK_THAT(page, ContainsSubstring("Beside physics.drag "));
  CHECK_THAT(page, ContainsSubstring("radii of the egg"));
  CHECK_THAT(page, ContainsSubstring("The lineage is the same in all runs."));
}

TEST_CASE("A run that failed says why, first of all") {
  RunToReport stored;
  // With too little pressure the shell turns the egg inside out within some twenty steps.
  endsWith(4, {"run", uniqueFour, "--db", stored.database, "--out", stored.folder.path(), "--quiet", "--set",
               "physics.pressure.constant=3"});
  const std::string page = stored.report();
  CHECK_THAT(page, ContainsSubstring("The run failed: "));
  CHECK_THAT(page, ContainsSubstring("There are faults."));
}

TEST_CASE("A check leaves a page of what differs") {
  const TemporaryFolder folder;
  const std::string scenario = folder / "small.yaml";
  writeWhole(scenario, summarisedScene);
  accept(scenario);
  succeeds({"check", scenario, "--reports", folder / "out"});
  CHECK_THAT(readWhole(folder / "out/report.html"), ContainsSubstring("1 of 1 scenario passes"));
  writeWhole(scenario, replaced(summarisedScene, "stop: {time: 1.5}", "stop: {time: 1.6}"));
  endsWith(1, {"check", scenario, "--reports", folder / "out"});
  const std::string page = readWhole(folder / "out/report.html");
  CHECK_THAT(page, ContainsSubstring("1 of 1 scenario differs"));
  CHECK_THAT(page, ContainsSubstring("stop.time: 1.5 → 1.6"));
  CHECK_THAT(page, ContainsSubstring("same lineage") || ContainsSubstring("lineage: "));
  CHECK_THAT(page, ContainsSubstring("<code>morula explain"));
  succeeds({"report", folder / "out", "-o", folder / "again.html"});
}

TEST_CASE("A page of a study: its verdicts first, then every value and its runs") {
  RunToReport stored;
  const std::string study = stored.runStudy(
      "morula-study: 1\nname: two\nbase: small.yaml\nvary:\n  drag:\n    less: {physics.drag: 1}\n"
      "    more: {physics.drag: 4}\nseeds: 1..2\nmeasures: [sphericity]\nkeep: {pictures: first-seed}\n");
  const std::string page = stored.reportOf(study, {"--frames", "2"});
  CHECK_THAT(page, ContainsSubstring("2 of 2 distinct runs are done: 2 conditions, 2 seeds."));
  CHECK_THAT(page, ContainsSubstring("Every run is done and sane"));
  CHECK_THAT(page,
             ContainsSubstring("2 runs have divisions with an ambiguous axis, under <b>less</b> and <b>more</b>"));
  CHECK_THAT(page, ContainsSubstring("Seeds change nothing under <b>less</b>"));
  CHECK(page.find("Findings of the study") < page.find("id=\"explorer\""));
  CHECK_THAT(page, ContainsSubstring("less, seed 1"));
  CHECK_THAT(page, ContainsSubstring("id=\"provenance\""));
  CHECK_THAT(page, ContainsSubstring("the pictures that the study keeps in"));
  // The page names the runs that it holds; others are found by their names.
  CHECK_THAT(stored.reportOf(study, {"--frames", "2", "--run", "more, seed 1"}),
             ContainsSubstring("1 of 2 runs are here, first the conditions") && !ContainsSubstring("less, seed 1"));
  refuses({"report", study, "-o", stored.page, "--run", "more, seed 9"}, 6, "more, seed 9");
}

TEST_CASE("Any condition and seed of a study can be explored, as many as asked for and as fit") {
  RunToReport stored;
  writeWhole(stored.folder / "small.yaml", summarisedScene + "variation: {share: 0.05}\n");
  const std::string study = stored.runStudy(
      "morula-study: 1\nname: two\nbase: small.yaml\nvary:\n  drag:\n    little: {physics.drag: 1}\n"
      "    some: {physics.drag: 1.1}\n    much: {physics.drag: 9}\nseeds: 1..3\nmeasures: [sphericity]\n");
  const auto titles = [&](const Words& options) {
    const std::string page = stored.reportOf(study, joined({"--frames", "3"}, options));
    Words found;
    const std::string before = "\"title\":\"";
    for (auto at = page.find(before); at != page.npos; at = page.find(before, at + 1))
      found.push_back(page.substr(at + before.size(), page.find('"', at + before.size()) - at - before.size()));
    return found;
  };
  const auto all = titles({});
  if (all.empty()) return;  // without Node.js the page has no explorer
  CHECK(all.size() == 9);
  CHECK(std::set<std::string>(all.begin(), all.end()).size() == 9);
  const std::set<std::string> first(all.begin(), all.begin() + 2);
  CHECK(first.contains("much, seed 1"));  // compared with little or some, which hardly differ
  CHECK(titles({"--explore", "5"}).size() == 5);
  CHECK(titles({"--size-limit", "10k"}).size() < 9);
}

TEST_CASE("A page is written over no page of others") {
  RunToReport stored;
  stored.run();
  writeWhole(stored.folder / "mine.html", "<p>by hand</p>");
  refuses({"report", stored.database, "-o", stored.folder / "mine.html"}, 6, "mine.html");
}

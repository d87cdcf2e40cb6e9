// Units: people see them, programs do not.
#include <cstdio>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("people see a scenario's units in texts and pages, programs the scene's own, and the run is the same") {
  const TemporaryFolder folder;
  const std::string plain =
      "morula: 1\nname: two\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.5}\n"
      "physics: {mesh: {icosphere: 1}}\ndivision: {plane: {axis: [1, 0, 0]}}\n";
  writeWhole(folder / "plain.yaml", plain);
  writeWhole(folder / "units.yaml", plain + "units: {length: µm, per-length: 27, time: min, per-time: 4}\n");
  const auto run = [&](const std::string& name) {
    const auto database = folder / (name + ".db");
    // Without contact cells end in each other, which is not sane.
    const Json json = jsonOf({"run", folder / (name + ".yaml"), "--db", database, "--quiet", "--no-pictures"}, 1);
    const auto text =
        launch({"run", folder / (name + ".yaml"), "--db", folder / (name + "-text.db"), "--no-pictures"}).out;
    return std::pair(json, text);
  };
  const auto [own, ownText] = run("plain");
  const auto [shown, shownText] = run("units");
  CHECK(shown["run_id"] == own["run_id"]);
  CHECK(shown["state_hash"] == own["state_hash"]);
  CHECK(shown["sample"] == own["sample"]);
  CHECK(own["units"] == Json::object());
  CHECK(shown["units"] ==
        Json{{"length", {{"name", "µm"}, {"factor", 27}}}, {"time", {{"name", "min"}, {"factor", 4}}}});
  CHECK_THAT(ownText, ContainsSubstring("at time 1.5 after"));
  CHECK_THAT(shownText, ContainsSubstring("at time 6 min after"));

  // Names of units come from the scenario, or from the database, which keeps the scenario.
  for (const auto& file : {folder / "units.yaml", folder / "units.db"}) {
    CHECK_THAT(launch({"lineage", file}).out, ContainsSubstring("egg  divided 0–4 min"));
    CHECK_THAT(launch({"lineage", file, "--cell", "A"}).out, ContainsSubstring("born       4 min"));
    CHECK(jsonOf({"lineage", file})["cells"][0]["ended"] == 1.0);
    CHECK(jsonOf({"lineage", file})["units"] == shown["units"]);
    CHECK(jsonOf({"lineage", file, "--cell", "A"})["units"] == shown["units"]);
  }
  CHECK(launch({"replay", folder / "units.db"}).code == 0);
  succeeds({"report", folder / "units.db", "-o", folder / "page.html"});
  const std::string page = readWhole(folder / "page.html");
  CHECK_THAT(page, ContainsSubstring("2 cells at time 6 min after"));
  CHECK_THAT(page, ContainsSubstring("Volume [µm³]"));
  launch({"run", folder / "units.yaml", "--set", "physics.drag=1", "--db", folder / "drag.db", "--no-pictures",
          "--quiet"});
  succeeds({"report", folder / "units.db", folder / "drag.db", "--frames", "0", "-o", folder / "both.html"});
  CHECK_THAT(readWhole(folder / "both.html"), ContainsSubstring("<td>6 min</td>"));  // in the table of runs
}

TEST_CASE("a study's findings for people are in the known units of its scenario, and units stand beside all numbers") {
  const TemporaryFolder folder;
  writeWhole(folder / "pair.yaml",
             "morula: 1\nname: pair\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 1.5}\n"
             "physics: {mesh: {icosphere: 1}, drag: 5, contact: {}}\nvariation: {share: 0.05}\n"
             "units: {length: µm, per-length: 10, time: min, per-time: 4}\n");
  writeWhole(folder / "pair.study.yaml",
             "morula-study: 1\nname: pair\nbase: pair.yaml\n"
             "vary: {drag: {little: {physics.drag: 4}, much: {physics.drag: 8}}}\nseeds: 1..3\n"
             "measures: {names: [extent, sphericity], when: {every: 0.5}}\n");
  const std::string to = folder / "results";
  succeeds({"study", "run", folder / "pair.study.yaml", "--out", to, "--quiet"});
  const Json json = jsonOf({"compare", to});
  const Json length{{"unit", "length"}, {"known_unit", {{"name", "µm"}, {"factor", 10}}}};
  CHECK(json["units"]["extent"] == length);
  CHECK(json["units"]["sphericity"] == Json{{"unit", ""}});
  CHECK(json["units"]["time"]["known_unit"]["name"] == "min");
  const double mean = json["conditions"][0]["mean"];
  REQUIRE(json["conditions"][0]["measure"] == "extent");
  CHECK((mean > 0.5 && mean < 3));  // lengths of the scene
  const std::string text = succeeds({"compare", to}).out;
  char shown[32];
  std::snprintf(shown, sizeof shown, "%.4g", 10 * mean);
  CHECK_THAT(text, ContainsSubstring("extent [µm]") && ContainsSubstring(shown) && ContainsSubstring("time [min]") &&
                       ContainsSubstring("Numbers with lengths or times in them are in µm and min"));
  CHECK_THAT(succeeds({"compare", to, "--tidy", "runs"}).out,
             ContainsSubstring("drag,seed,time,measure,value,unit\nlittle,1,0,extent,") &&
                 ContainsSubstring(",length\n") && !ContainsSubstring("µm"));
  const std::string csv = succeeds({"compare", to, "--csv"}).out;
  CHECK_THAT(csv.substr(0, csv.find('\n')), ContainsSubstring(",unit"));
  succeeds({"export", to + "/study.db", "--format", "csv", "--table", "results", "-o", folder / "results.csv"});
  CHECK_THAT(readWhole(folder / "results.csv"),
             ContainsSubstring("run_id,measure,time,value,unit\r\n") && ContainsSubstring(",length\r\n"));
  succeeds({"report", to + "/study.db", "-o", folder / "page.html"});
  CHECK_THAT(readWhole(folder / "page.html"), ContainsSubstring("extent [µm]"));
}

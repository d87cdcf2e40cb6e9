// Units: people see them, programs do not.
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
  CHECK_THAT(ownText, ContainsSubstring("at time 1.5 after"));
  CHECK_THAT(shownText, ContainsSubstring("at time 6 min after"));

  // Names of units come from the scenario, or from the database, which keeps the scenario.
  for (const auto& file : {folder / "units.yaml", folder / "units.db"}) {
    CHECK_THAT(launch({"lineage", file}).out, ContainsSubstring("egg  divided 0–4 min"));
    CHECK_THAT(launch({"lineage", file, "--cell", "A"}).out, ContainsSubstring("born       4 min"));
    CHECK(jsonOf({"lineage", file})["cells"][0]["ended"] == 1.0);
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

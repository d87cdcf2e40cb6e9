// Names of cells in the program's output.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

namespace {

const std::string worm =
    "morula: 1\nname: worm\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\nstop: {cycles: 2}\n"
    "names: {egg: P0, daughters: [a, p], cells: {A: AB, B: P1}}\n";

}  // namespace

TEST_CASE("names stand at the lines of a lineage, from the scenario and from the database, and in JSON") {
  const TemporaryFolder folder;
  const auto scenario = folder / "worm.yaml", database = folder / "worm.db";
  writeWhole(scenario, worm);
  succeeds({"run", scenario, "--db", database, "--quiet", "--no-pictures"});
  for (const auto& file : {scenario, database}) {
    INFO(file);
    CHECK_THAT(launch({"lineage", file}).out,
               ContainsSubstring("egg  P0  divided") && ContainsSubstring("    BB  P1p  alive"));
    const Json json = jsonOf({"lineage", file});
    CHECK(json["cells"][1]["path"] == "A");
    CHECK(json["cells"][1]["name"] == "AB");
  }
  CHECK(launch({"replay", database}).code == 0);  // the names are reproduced too
}

TEST_CASE("a failure names its cell, and says her path") {
  const TemporaryFolder folder;
  const auto scenario = folder / "worm.yaml";
  // The step is short enough for the egg, and too long for the light vertices of her granddaughters.
  writeWhole(scenario, worm + "physics: {time_step: 0.0078125, mesh: {icosphere: 1}}\n");
  const auto run =
      endsWith(4, {"run", scenario, "--db", folder / "worm.db", "--quiet", "--no-pictures", "--set", "stop.cycles=6"});
  CHECK_THAT(run.err, ContainsSubstring("P1app (path BABB): physics.time_step 0.0078125 is above"));
}

TEST_CASE("lineage --cell tells one life, by name or path, from the scenario and from the database") {
  const TemporaryFolder folder;
  const auto scenario = folder / "worm.yaml", database = folder / "worm.db";
  writeWhole(scenario, worm);
  succeeds({"run", scenario, "--db", database, "--quiet", "--no-pictures"});
  for (const auto& file : {scenario, database}) {
    INFO(file);
    CHECK(launch({"lineage", file, "--cell", "P1"}).out ==
          "path       B\nname       P1\nborn       1\nended      2\nfate       divided\nstate      a0 divide\n"
          "mother     P0 (the egg)\ndaughters  P1a (path BA), P1p (path BB)\nsister     AB (path A)\n");
    CHECK(launch({"lineage", file, "--cell", "ABp"}).out ==
          "path       AB\nname       ABp\nborn       2\nended      not before the run's end, 2\nfate       alive\n"
          "state      B a0 divide\nmother     AB (path A)\nsister     ABa (path AA)\n");
    CHECK(launch({"lineage", file, "--cell", "/AB"}).out == launch({"lineage", file, "--cell", "ABp"}).out);
    const auto egg = launch({"lineage", file, "--cell", "egg"}).out;
    CHECK_THAT(egg, ContainsSubstring("path       egg\nname       P0\n"));
    CHECK_THAT(egg, !ContainsSubstring("mother"));
    const Json json = jsonOf({"lineage", file, "--cell", "AB"});
    CHECK(json["scenario"] == "worm");
    Json cell = json["cell"];
    CHECK(cell["mother"] == Json{{"path", ""}, {"name", "P0"}});
    CHECK(cell["sister"] == Json{{"path", "B"}, {"name", "P1"}});
    REQUIRE(cell["daughters"].size() == 2);
    CHECK(cell["daughters"][1] == Json{{"path", "AB"}, {"name", "ABp"}});
    for (const char* relative : {"mother", "sister", "daughters"}) cell.erase(relative);
    CHECK(cell == jsonOf({"lineage", file})["cells"][1]);  // the name comes before the path
    const Json root = jsonOf({"lineage", file, "--cell", "P0"})["cell"];
    CHECK(root["mother"].is_null());
    CHECK(root["sister"].is_null());
  }
}

TEST_CASE("lineage --cell refuses what is no cell of the tree, and says what is near") {
  const TemporaryFolder folder;
  const auto scenario = folder / "worm.yaml";
  writeWhole(scenario, replaced(worm, "B: P1", "B: EMS"));
  refuses({"lineage", scenario, "--cell", "EMz"}, 2, "--cell: 'EMz' is no cell's name or path; did you mean EMS?");
  refuses({"lineage", scenario, "--cell", "Z"}, 2,
          "--cell: 'Z' is no cell's name or path; needs egg, or a path of the letters A and B");
  refuses({"lineage", scenario, "--cell", "ABpa"}, 2,
          "--cell: ABpa (path ABA) was never born: ABp (path AB) lives at the run's end, 2; needs a cell "
          "that 'morula lineage' lists without --cell");
  refuses({"lineage", scenario, "--cell", "P0", "-o", folder / "x.png"}, 2,
          "--cell and --output: give only one of them");
  // A dead cell has no daughters; her line ends with her.
  writeWhole(scenario,
             "morula: 1\nname: short\ndna: |\n  START: a0\n  g1(divide|a0)\n  g2(die|A)\nstop: {cycles: 3}\n");
  CHECK_THAT(launch({"lineage", scenario, "--cell", "A"}).out, ContainsSubstring("fate       died\n"));
  CHECK_THAT(launch({"lineage", scenario, "--cell", "AB"}).err,
             ContainsSubstring("cell AB was never born: cell A died at 2"));
}

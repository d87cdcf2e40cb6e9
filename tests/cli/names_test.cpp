// Names of cells, where people meet them.
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
  REQUIRE(launch({"run", scenario, "--db", database, "--quiet", "--no-pictures"}).code == 0);
  for (const auto& file : {scenario, database}) {
    INFO(file);
    const auto text = launch({"lineage", file});
    CHECK_THAT(text.out, ContainsSubstring("egg  P0  divided"));
    CHECK_THAT(text.out, ContainsSubstring("    BB  P1p  alive"));
    const Json json = Json::parse(launch({"lineage", file, "--json"}).out);
    CHECK(json["cells"][1]["path"] == "A");
    CHECK(json["cells"][1]["name"] == "AB");
  }
  CHECK(launch({"replay", database}).code == 0);  // the names, too, come out again
}

TEST_CASE("a failure names its cell, and says her path") {
  const TemporaryFolder folder;
  const auto scenario = folder / "worm.yaml";
  // A step that is short enough for the egg, and too long for her daughters' daughters' light vertices.
  writeWhole(scenario, worm + "physics: {time_step: 0.0078125, mesh: {icosphere: 1}}\n");
  const auto run = launch(
      {"run", scenario, "--db", folder / "worm.db", "--quiet", "--no-pictures", "--set", "stop.cycles=6"});
  CHECK(run.code == 4);
  CHECK_THAT(run.err, ContainsSubstring("P1app (path BABB): physics.time_step 0.0078125 is above"));
}

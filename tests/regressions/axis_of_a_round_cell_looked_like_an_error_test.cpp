// A round cell has no longest extent, so rounding chose where it was cut, and a table of errors showed 0.2
// for every time step of another precision. accuracy says which cell is cut elsewhere, when, and how round it
// was.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("accuracy: where an ambiguous axis parts two runs, a remark says so") {
  const TemporaryFolder folder;
  // Two eggs press each other a little out of round along no axis that the mesh prefers.
  writeWhole(
      folder / "round.yaml",
      "morula: 1\nname: round\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\ncycle: {length: 0.25}\n"
      "stop: {time: 0.5}\nphysics:\n  time_step: 0.001953125\n  mesh: {icosphere: 1}\n  drag: 10\n"
      "  cell: {radius: 0.95}\n  contact: {}\n  shell: {ellipsoid: [1, 1, 2]}\n"
      "cells:\n  - {at: [0, 0, 0], stretch: [1, 1.0000001, 0.9]}\n");
  const auto run = launch({"accuracy", folder / "round.yaml", "--json", "--quiet", "--rounds", "1",
                           "--halvings", "1", "--integrator", "velocity-verlet", "--out", folder.path()});
  CAPTURE(run.err);
  REQUIRE(run.code == 0);
  const Json json = Json::parse(run.out);
  bool remarked = false;
  for (const auto& remark : json["remarks"])
    remarked |= remark.get<std::string>().find("across another") != std::string::npos;
  bool cut = !json["mesh"]["divided_elsewhere"].is_null();
  for (const Json& row : json["rows"]) cut |= !row["divided_elsewhere"].is_null();
  CHECK(remarked == cut);
  CHECK(cut);
}

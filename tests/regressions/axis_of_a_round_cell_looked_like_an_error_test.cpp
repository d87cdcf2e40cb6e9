// A round cell has no longest extent, so rounding chose its division plane, and a table of errors showed 0.2 for every
// time step of another precision. Now accuracy says which cell is cut elsewhere, when, and how round it was.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("accuracy: where an ambiguous axis parts two runs, a remark says so") {
  const TemporaryFolder folder;
  // A flattened egg swings through a round shape, and divides when it is round. With 42 vertices its longest extent is
  // still x; with 162, which swing a little faster, it is already z.
  writeWhole(folder / "round.yaml",
             "morula: 1\nname: round\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(divide|a0)\ncycle: {length: "
             "0.1267089844}\n"
             "stop: {time: 0.2}\nphysics:\n  time_step: 0.00048828125\n  mesh: {icosphere: 1}\n  drag: 1\n"
             "  cell: {radius: 0.95}\n  contact: {}\n"
             "cells:\n  - {at: [0, 0, 0], stretch: [1, 1, 0.8]}\n");
  const Json json = jsonOf({"accuracy", folder / "round.yaml", "--quiet", "--rounds", "1", "--halvings", "1",
                            "--integrator", "velocity-verlet", "--out", folder.path()});
  bool remarked = false;
  for (const auto& remark : json["remarks"])
    remarked |= remark.get<std::string>().find("across another") != std::string::npos;
  bool cut = !json["mesh"]["divided_elsewhere"].is_null();
  for (const Json& row : json["rows"]) cut |= !row["divided_elsewhere"].is_null();
  CHECK(remarked == cut);
  CHECK(cut);
}

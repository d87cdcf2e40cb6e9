// `lineage --json` gave no end for living cells, so the lifetime of a leaf was unknown. Now their end is the run's end,
// with fate alive.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("lineage --json: a living leaf ends with the run") {
  const TemporaryFolder folder;
  const std::string file = folder / "small.yaml", db = folder / "run.db";
  writeWhole(file, "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 2.5}\n");
  succeeds({"run", file, "--db", db, "--no-pictures", "--out", folder / "out"});
  for (const std::string& what : {file, db}) {
    const Json json = jsonOf({"lineage", what});
    int leaves = 0;
    for (const auto& cell : json["cells"]) {
      if (cell["fate"] != "alive") continue;
      ++leaves;
      CHECK(cell["ended"] == json["time"]);
      CHECK(cell["ended"] > cell["born"]);
    }
    CHECK(leaves == 2);
  }
}

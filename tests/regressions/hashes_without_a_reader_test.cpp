// Two thirds of a study's disk was cell_hash, stored because the scenario has `check:` although --no-check was given.
// Now only checked runs store hashes of intermediate states, commands that need missing hashes say so, and `export
// --list` explains each table.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula::test;
using Json = nlohmann::json;

TEST_CASE("a run that is not checked stores no hashes, and each table says why it is there") {
  const TemporaryFolder folder;
  const std::string file = folder / "small.yaml";
  writeWhole(file, "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 3}\ncheck: {}\n");
  const auto tablesAfter = [&](const std::string& db, const Words& more) {
    succeeds(joined({"run", file, "--db", db, "--no-pictures", "--out", folder / "out"}, more));
    std::map<std::string, Json> tables;
    const Json json = jsonOf({"export", db, "--list"});
    for (const auto& t : json["tables"]) tables[t["table"]] = t;
    return tables;
  };
  auto checked = tablesAfter(folder / "checked.db", {});
  CHECK(checked["cell_hash"]["rows"] > 3);
  CHECK(checked["cell_hash"]["bytes"] > 0);
  morula::Database db = opened(folder / "checked.db");
  CHECK(db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table'") ==
        static_cast<std::int64_t>(checked.size()));
  for (const auto& [name, table] : checked) {
    CAPTURE(name);
    CHECK(table["why"] != "");
    CHECK(table["rows"] == db.integer("SELECT count(*) FROM " + name));
  }
  for (const Words& more : {Words{"--no-check"}, {"--seed", "7"}, {"--set", "stop.time=2"}}) {
    CAPTURE(more[0]);
    auto unchecked = tablesAfter(folder / ("un" + more[0].substr(2) + ".db"), more);
    CHECK(unchecked["cell_hash"]["rows"] == 0);
    CHECK(unchecked["step_hash"]["rows"] == 0);
    CHECK(unchecked["cell"]["rows"] == 3);
  }
  CHECK_THAT(endsWith(3, {"explain", file, "--db", folder / "unno-check.db"}).err,
             ContainsSubstring("kept no chain") && ContainsSubstring("without --no-check"));
  CHECK(launch({"replay", folder / "unno-check.db"}).code == 0);
  CHECK_THAT(launch({"export", folder / "checked.db", "--list"}).out, ContainsSubstring("which cells differ"));
}

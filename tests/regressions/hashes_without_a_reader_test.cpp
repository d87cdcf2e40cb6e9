// Two thirds of a study's disk was cell_hash, stored because the scenario has `check:` although --no-check
// was said. Hashes of the states on the way are stored only of a run that is checked, who would read them is
// told if they are not there, and `export --list` says of each table what it holds and why.
#include <nlohmann/json.hpp>

#include "catch.h"
#include "database/database.h"
#include "launch.h"

using namespace morula::test;
using morula::Database;
using Json = nlohmann::json;

TEST_CASE("a run that is not checked stores no hashes, and each table says why it is there") {
  const TemporaryFolder folder;
  const std::string file = folder / "small.yaml";
  writeWhole(file, "morula: 1\nname: small\ndna: |\n  START: a0\n  g1(divide|a0)\nstop: {time: 3}\ncheck: {}\n");
  const auto tablesAfter = [&](const std::string& db, std::vector<std::string> more) {
    more.insert(more.begin(), {"run", file, "--db", db, "--no-pictures", "--out", folder / "out"});
    REQUIRE(launch(more).code == 0);
    const auto list = launch({"export", db, "--list", "--json"});
    INFO(list.err);
    REQUIRE(list.code == 0);
    std::map<std::string, Json> tables;
    const Json json = Json::parse(list.out);
    for (const auto& t : json["tables"]) tables[t["table"]] = t;
    return tables;
  };
  auto checked = tablesAfter(folder / "checked.db", {});
  CHECK(checked["cell_hash"]["rows"] > 3);
  CHECK(checked["cell_hash"]["bytes"] > 0);
  Database db(folder / "checked.db", Database::Mode::existing, std::chrono::seconds(5));
  CHECK(db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table'") ==
        static_cast<std::int64_t>(checked.size()));
  for (const auto& [name, table] : checked) {
    CAPTURE(name);
    CHECK(table["why"] != "");
    CHECK(table["rows"] == db.integer("SELECT count(*) FROM " + name));
  }
  for (const auto& more : {std::vector<std::string>{"--no-check"}, {"--seed", "7"}, {"--set", "stop.time=2"}}) {
    CAPTURE(more[0]);
    auto unchecked = tablesAfter(folder / ("un" + more[0].substr(2) + ".db"), more);
    CHECK(unchecked["cell_hash"]["rows"] == 0);
    CHECK(unchecked["step_hash"]["rows"] == 0);
    CHECK(unchecked["cell"]["rows"] == 3);
  }
  const auto explained = launch({"explain", file, "--db", folder / "unno-check.db"});
  CHECK(explained.code == 3);
  CHECK_THAT(explained.err, ContainsSubstring("kept no chain") && ContainsSubstring("without --no-check"));
  CHECK(launch({"replay", folder / "unno-check.db"}).code == 0);
  CHECK_THAT(launch({"export", folder / "checked.db", "--list"}).out, ContainsSubstring("which cells differ"));
}

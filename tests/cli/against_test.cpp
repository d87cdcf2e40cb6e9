// run --against: a run's own samples as a table, what is said of them, and where they are stored and shown.
#include <cmath>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "launch.h"
#include "stored.h"

using namespace morula;
using namespace morula::test;

namespace {

const Words withoutPictures{"--no-pictures", "--no-check", "--quiet"};

}  // namespace

TEST_CASE("a run's own samples as a table of times lie at distance 0 of it, and their comparison is stored and shown") {
  const TemporaryFolder folder;
  const std::string first = folder / "first.db", again = folder / "again.db";
  const Words scene{uniqueFour, "--set", "record.every=0.5"};
  succeeds(joined(joined({"run"}, scene), joined(withoutPictures, {"--db", first})));
  succeeds({"export", first, "--format", "csv", "-o", folder / "tables"});
  const Words against{"--against", folder / "tables/cell_samples.csv", "--against-units", "scene", "--db", again};
  const auto said = jsonOf(joined(joined({"run"}, scene), joined(withoutPictures, against)));
  const auto& stages = said.at("against").at("stages");
  REQUIRE(stages.size() > 3);
  CHECK(said.at("against").at("remarks").empty());
  std::size_t compared = 0;
  for (const auto& stage : stages) {
    CHECK(stage.at("time") == stage.at("of_time"));
    CHECK(stage.at("not_in_run").empty());
    CHECK(stage.at("not_in_table").empty());
    if (stage.at("cells").get<int>() < 3) {
      CHECK(stage.at("why") == "fewer than three cells are in both");
    } else {
      ++compared;
      CHECK(stage.at("rmsd").get<double>() < 1e-12);
    }
  }
  CHECK(compared > 0);
  CHECK(integerIn(again, "SELECT count(*) FROM against_stage WHERE rmsd < 1e-12") == static_cast<int>(compared));
  CHECK(integerIn(again, "SELECT count(*) FROM against_cell WHERE found_in = 'both'") ==
        integerIn(again, "SELECT count(*) FROM cell_sample"));
  // The comparison changes nothing in the run.
  const std::string hash = "SELECT state_hash = '" + said.at("state_hash").get<std::string>() + "' FROM run";
  CHECK(integerIn(first, hash) == 1);
  CHECK(integerIn(first, "SELECT count(*) FROM against_stage") == 0);
  CHECK_THAT(succeeds({"replay", again}).out, ContainsSubstring("against_stage, against_cell"));
  succeeds({"report", again, "-o", folder / "page.html"});
  CHECK_THAT(readWhole(folder / "page.html"), ContainsSubstring("Measured places"));
}

TEST_CASE("a stage of a number of cells is compared in its middle") {
  const TemporaryFolder folder;
  const std::string first = folder / "first.db";
  const Words scene{uniqueFour, "--set", "record.every=0.01"};
  succeeds(joined(joined({"run"}, scene), joined(withoutPictures, {"--db", first})));
  const double middle = realIn(first, "SELECT 0.5 * (min(time) + max(time)) FROM sample WHERE cells = 4");
  std::string table = "cells,path,x,y,z\n";
  {
    Database db = opened(first);
    Statement row(
        db,
        "SELECT path, x, y, z FROM cell_sample WHERE time = (SELECT time FROM sample WHERE cells = 4 ORDER BY "
        "abs(time - " +
            std::to_string(middle) + ") LIMIT 1)");
    while (row.next())
      table += "4," + row.text(0) + "," + std::to_string(row.real(1)) + "," + std::to_string(row.real(2)) + "," +
               std::to_string(row.real(3)) + "\n";
  }
  writeWhole(folder / "table.csv", table);
  const auto said = jsonOf(
      joined(joined({"run"}, scene), joined(withoutPictures, {"--against", folder / "table.csv", "--against-units",
                                                              "scene", "--db", folder / "again.db"})));
  const auto& stage = said.at("against").at("stages").at(0);
  const double length = realIn(first, "SELECT max(time) - min(time) FROM sample WHERE cells = 4");
  CHECK(std::abs(stage.at("time").get<double>() - middle) < 0.01 * length + 0.01);
  CHECK(stage.at("rmsd").get<double>() < 0.01);
  const auto text =
      succeeds(joined(joined({"run"}, scene),
                      joined(withoutPictures, {"--against", folder / "table.csv", "--db", folder / "text.db"})));
  CHECK_THAT(text.out, ContainsSubstring("4 cells") && ContainsSubstring("Farthest cells"));
}

// One number for each measure and time, against sums by hand.
#include <array>

#include "base/error.h"
#include "catch.h"
#include "observation/asked_measure.h"
#include "tasks/run_study.h"
#include "tasks/run_task.h"

using namespace morula;

namespace {

Scenario withSubstances(std::vector<std::string> substances) {
  Scenario scenario;
  scenario.scene.dna.substances = std::move(substances);
  return scenario;
}

}  // namespace

TEST_CASE("a measure of cells is their mean, of the world itself, and what is not there has no row") {
  Sample start, end;
  start.world["cells"] = 1;
  end.world.time = 2;
  end.world["cells"] = 2;
  end.cells.resize(3);
  for (int i = 0; i < 3; ++i) end.cells[std::size_t(i)].path = CellPath::parse(std::array{"A", "BA", "BB"}[i]);
  end.cells[0]["sphericity"] = 0.5;
  end.cells[1]["sphericity"] = 0.75;  // the third cell was not measured
  end.more = {{Scope::world, "lineage_space", {}, {}, 0.25},
              {Scope::cell, "generation", CellPath::parse("A"), {}, 1},
              {Scope::cell, "generation", CellPath::parse("BA"), {}, 2},
              {Scope::pair, "kinship", CellPath::parse("A"), CellPath::parse("B"), 3}};
  const auto rows = valuesOf({start, end}, {}, {"cells", "sphericity", "lineage_space", "generation", "kinship"}, {});
  const std::vector<ResultRow> expected{{"cells", 0, 1},          {"cells", 2, 2},
                                        {"sphericity", 2, 0.625}, {"lineage_space", 2, 0.25},
                                        {"generation", 2, 1.5},   {"kinship", 2, 3}};
  CHECK(rows == expected);
}

TEST_CASE("a measure of some cells is the mean over these, and of pairs with one of them") {
  Sample sample;
  sample.cells.resize(4);
  const char* paths[] = {"AA", "AB", "BA", "BB"};
  for (std::size_t i = 0; i < 4; ++i) {
    sample.cells[i].path = CellPath::parse(paths[i]);
    sample.cells[i].state = static_cast<StateId>(i % 2);
    sample.cells[i]["sphericity"] = double(i);
  }
  sample.more = {{Scope::cell, "generation", CellPath::parse("AB"), {}, 5},
                 {Scope::cell, "generation", CellPath::parse("BB"), {}, 7}};
  const auto touch = [&](const char* a, const char* b, double area) {
    ContactMeasures c;
    c.a = CellPath::parse(a), c.b = CellPath::parse(b), c["area"] = area;
    sample.contacts.push_back(c);
  };
  touch("AA", "AB", 1), touch("AB", "BA", 3), touch("BA", "BB", 8);
  const std::map<StateId, std::string> states{{0, "skin"}, {1, "gut s1"}};
  const Scenario scenario = withSubstances({"skin", "gut", "s1"});
  const auto value = [&](const char* measure) { return valuesOf({sample}, states, {measure}, scenario).at(0).value; };
  CHECK(value("sphericity of B*") == 2.5);
  CHECK(value("sphericity of AB") == 1);
  CHECK(value("sphericity of generation 2") == 1.5);
  CHECK(value("sphericity of skin") == 1);
  CHECK(value("generation of B*") == 7);
  CHECK(value("pair.area of AB") == 2);
  CHECK(value("pair.area of B*") == 5.5);
  CHECK(value("count of g*") == 2);
  CHECK(value("count of s1") == 2);
  CHECK(value("count of AAB*") == 0);
  CHECK(valuesOf({sample}, states, {"sphericity of AAB*"}, scenario).empty());  // nothing was measured
}

TEST_CASE("ratios, differences and distances are of the means of their cells, and nothing where one is missing") {
  Sample sample;
  sample.world["volume"] = 10;
  sample.cells.resize(3);
  const char* paths[] = {"AA", "AB", "B"};
  for (std::size_t i = 0; i < 3; ++i) {
    sample.cells[i].path = CellPath::parse(paths[i]);
    sample.cells[i]["volume"] = double(1 + i);
    sample.cells[i]["x"] = 3 * double(i), sample.cells[i]["y"] = 4 * double(i), sample.cells[i]["z"] = 0;
  }
  Scenario scenario = withSubstances({"skin", "AB"});
  scenario.names.given = {{CellPath::parse("B"), "P1"}, {CellPath::parse("AA"), "skin"}};
  const std::map<StateId, std::string> states{{0, "skin"}};
  const auto values = [&](const char* measure) { return valuesOf({sample}, states, {measure}, scenario); };
  CHECK(values("cell.volume of cell P1 / cell.volume of path AA").at(0).value == 3);
  CHECK(values("cell.volume of P1 / cell.volume of path A*").at(0).value == 2);
  CHECK(values("cell.volume of clone P1 - cell.volume of path A*").at(0).value == 1.5);
  CHECK(values("world.volume / count of generation 2").at(0).value == 5);
  CHECK(values("distance path AA P1").at(0).value == 10);
  CHECK(values("distance path A* cell P1").at(0).value == 7.5);
  CHECK(values("distance cell P1 path BB").empty());
  CHECK(values("world.volume / count of path BB").empty());  // 10 / 0
  CHECK(values("distance cell P1 path AA").at(0).measure == "distance cell P1 path AA");
  CHECK_THROWS_WITH(values("cell.volume of skin"), Catch::Contains("write 'cell skin' or 'substance skin'"));
  CHECK_THROWS_WITH(values("cell.volume of AB"), Catch::Contains("write 'path AB' or 'substance AB'"));
}

TEST_CASE("names that two tables have are told apart") {
  Sample sample;
  sample.world["volume"] = 8;
  sample.cells.resize(2);
  sample.cells[0].path = CellPath::parse("A"), sample.cells[1].path = CellPath::parse("B");
  sample.cells[0]["volume"] = 3, sample.cells[1]["volume"] = 5;
  for (const AskedMeasure& m : allMeasures())
    if (m.row == "volume" && m.scope == Scope::cell) CHECK(valuesOf({sample}, {}, {m.name}, {}).at(0).value == 4);
    else if (m.row == "volume" && m.scope == Scope::world) CHECK(valuesOf({sample}, {}, {m.name}, {}).at(0).value == 8);
}

TEST_CASE("shares are all of the tasks, each once, and even") {
  for (const std::size_t of : {1, 2, 3, 7, 40}) {
    std::vector<int> seen(23, 0);
    std::size_t least = 23, most = 0;
    for (std::size_t number = 1; number <= of; ++number) {
      const auto tasks = tasksOf({number, of}, 23);
      least = std::min(least, tasks.size()), most = std::max(most, tasks.size());
      for (const std::size_t task : tasks) ++seen.at(task);
    }
    CHECK(seen == std::vector<int>(23, 1));
    CHECK(most - least <= 1);
  }
  CHECK(parseShard("3/40").number == 3);
  for (const char* wrong : {"0/4", "5/4", "3", "3/", "/4", "-1/4", "1/2/3", "a/b", "1/1000001", " 1/2"})
    CHECK_THROWS_AS(parseShard(wrong), InputError);
}

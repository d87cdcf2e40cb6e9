// A run compared with a table of measured cells: moved, changed, mirrored and scaled tables of its own places.
#include "check/against.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"

using namespace morula;

namespace {

const std::vector<Point> restPlaces{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}, {0, 0, 11},
                                    {4, 6, 1}, {9, 2, 3}, {1, 8, 8}, {7, 7, 7}};

std::string pathOf(std::size_t i) { return std::string{i & 4 ? 'B' : 'A', i & 2 ? 'B' : 'A', i & 1 ? 'B' : 'A'}; }

/// Returns eight balls that rest at `restPlaces`, one of which is called Anna.
Scenario balls(const std::string& units = "") {
  std::string cells;
  for (const Point& p : restPlaces)
    cells += fmt::format("{}{{at: [{}, {}, {}]}}", cells.empty() ? "" : ", ", p.x, p.y, p.z);
  return readScenario(
      "morula: 1\nname: s\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 1}\nphysics: {cell: "
      "{model: sphere}, drag: 1, time_step: 0.0625}\nnames: {cells: {AAA: Anna}}\n" +
          units + "cells: [" + cells + "]\n",
      "s.yaml", "");
}

/// Returns a table of eight cells at `at`, with lines "cells,path,x,y,z".
std::string table(const std::vector<Point>& at) {
  std::string text = "cells,path,x,y,z\n";
  for (std::size_t i = 0; i < at.size(); ++i)
    text += fmt::format("8,{},{:.17g},{:.17g},{:.17g}\n", pathOf(i), at[i].x, at[i].y, at[i].z);
  return text;
}

std::vector<AgainstStage> compared(const std::string& text, const Scenario& scenario = balls(),
                                   const tracks::MeasuredOptions& options = {}) {
  const auto measured = tracks::readMeasured(text, "t.csv", scenario.names, scenario.units, options);
  World world = makeWorld(scenario.scene);
  Against against(measured.stages);
  against.see(world);
  while (!finished(world)) {
    const auto most = against.stepsUntilDue(world);
    takeSteps(world, std::min<std::uint64_t>(most, 64));
    against.see(world);
  }
  return against.take(world);
}

/// Turns a point by a rotation about (1, 2, 2) / 3 of 1 radian, and moves it.
Point turned(const Point& p) {
  const Vector axis{1. / 3, 2. / 3, 2. / 3};
  const double c = std::cos(1.), s = std::sin(1.);
  return p * c + cross(axis, p) * s + axis * (dot(axis, p) * (1 - c)) + Vector{30, -20, 10};
}

std::vector<Point> changed(Point (*change)(const Point&)) {
  std::vector<Point> all;
  for (const Point& p : restPlaces) all.push_back(change(p));
  return all;
}

std::vector<std::string> remarks(const std::vector<AgainstStage>& stages) { return againstRemarks(stages, {}); }

}  // namespace

TEST_CASE("a table of the run's own places, turned and moved, lies at distance 0 at every stage") {
  const std::string turnedTable = table(changed(turned));
  const auto stages = compared(turnedTable);
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].compared == 8);
  CHECK(stages[0].rmsd.value() < 1e-13);
  CHECK(stages[0].scale.value() == Approx(1).epsilon(1e-13));
  CHECK(remarks(stages).empty());
  for (const AgainstCell& cell : stages[0].byCell) CHECK(cell.distance.value() < 1e-13);
}

TEST_CASE("times of a table are those of the first state at or after them, and later ones are told") {
  const auto stages = compared("time,name,x,y,z\n0.3,Anna,0,0,0\n0.3,AAB,5,0,0\n0.3,ABA,0,7,0\n7,AAA,1,1,1\n");
  REQUIRE(stages.size() == 2);
  CHECK(stages[0].ofTime == 0.3);
  CHECK(stages[0].time == 0.3125);  // the first multiple of 1/16
  CHECK(stages[0].compared == 3);
  CHECK(stages[0].rmsd.value() < 1e-13);
  CHECK(stages[1].why == "the run ends before");
}

TEST_CASE("one cell moved by d adds less than d √(n-1)/n, and stands first") {
  auto moved = restPlaces;
  const double d = 0.01;
  moved[5] += Vector{0, 0, d};
  const auto stages = compared(table(moved));
  const double most = d * std::sqrt(7.) / 8;  // as if the cells were moved alone, and not turned
  CHECK(stages[0].rmsd.value() <= most * (1 + 1e-9));
  CHECK(stages[0].rmsd.value() > 0.5 * most);
  CHECK(stages[0].byCell[0].path.text() == pathOf(5));
  double squares = 0;
  for (const AgainstCell& cell : stages[0].byCell) squares += *cell.distance * *cell.distance;
  CHECK(std::sqrt(squares / 8) == Approx(*stages[0].rmsd).epsilon(1e-12));
  CHECK(std::ranges::is_sorted(stages[0].byCell, std::ranges::greater(),
                               [](const AgainstCell& c) { return c.distance.value(); }));
}

TEST_CASE("a mirrored table and one in another unit are told") {
  const auto mirrored = compared(table(changed([](const Point& p) { return Point{-p.x, p.y, p.z}; })));
  CHECK(mirrored[0].rmsd.value() > 0.5);
  CHECK(mirrored[0].mirroredShapeRmsd.value() < 1e-13);
  REQUIRE(remarks(mirrored).size() == 1);
  CHECK_THAT(remarks(mirrored)[0], ContainsSubstring("at 8 cells the mirror image of the cells fits"));
  const std::string scaledTable = table(changed([](const Point& p) { return p * 17; }));
  const auto scaled = compared(scaledTable);
  CHECK(scaled[0].scale.value() == Approx(17).epsilon(1e-12));
  CHECK(scaled[0].shapeRmsd.value() < 1e-13);
  REQUIRE(remarks(scaled).size() == 1);
  CHECK_THAT(remarks(scaled)[0],
             ContainsSubstring("lie 17 times as far apart") && ContainsSubstring("--against-units"));
  // In a scenario of which one length is 17 µm they have the right unit.
  const Scenario scenario = balls("units: {length: µm, per-length: 17, time: min, per-time: 4}\n");
  CHECK(compared(scaledTable, scenario)[0].rmsd.value() < 1e-13);
  CHECK(compared(table(restPlaces), scenario, {.units = Units{}})[0].rmsd.value() < 1e-13);
  const Units half{.length = "µm", .time = "min", .perLength = 0.5, .perTime = 2};
  const auto halved = compared(table(changed([](const Point& p) { return p * 34; })), scenario, {.units = half});
  CHECK(halved[0].rmsd.value() < 1e-13);
  const auto timed = compared("time,name,x,y,z\n1,Anna,0,0,0\n1,AAB,10,0,0\n1,ABA,0,14,0\n", scenario, {.units = half});
  CHECK(timed[0].ofTime == 0.5);  // one time of the table is 2 min, half of the scene's
}

TEST_CASE("cells that only the table or only the run has are told by name") {
  const auto stages = compared(
      "cells,name,x,y,z\n8,Anna,0,0,0\n8,AAB,5,0,0\n8,ABA,0,7,0\n8,AA,1,1,1\n4,AA,0,0,0\n4,AB,1,0,0\n4,BA,0,1,0\n");
  REQUIRE(stages.size() == 2);
  CHECK(stages[0].why == "the run never has so many cells");
  CHECK(stages[1].compared == 3);
  const auto json = againstJson(stages, balls());
  CHECK(json[1]["not_in_run"] == Json{"AA"});
  CHECK(json[1]["not_in_table"].size() == 5);
  CHECK(json[1]["distances"][0]["cell"].get<std::string>().size() > 0);
  CHECK(json[0]["rmsd"].is_null());
  const std::string text = textOf(againstTable(stages, balls()));
  CHECK_THAT(text, ContainsSubstring("not in the run: AA") && ContainsSubstring("not in the table: ABB, BAA"));
}

TEST_CASE("a long table is cut for people, who are told so") {
  std::string text = "time,path,x,y,z\n";
  for (int i = 0; i < 10; ++i) text += fmt::format("0.{0},AAA,0,0,0\n0.{0},AAB,5,0,0\n0.{0},ABA,0,7,0\n", i);
  const auto stages = compared(text);
  CHECK_THAT(textOf(againstTable(stages, balls(), 4)),
             ContainsSubstring("6 further stages") && ContainsSubstring("time 0.3") && !ContainsSubstring("time 0.4"));
  CHECK_THAT(textOf(againstTable(stages, balls())), ContainsSubstring("time 0.9") && !ContainsSubstring("further"));
}

TEST_CASE("columns are found by the headers that are given") {
  const std::string text = "n,who,px,py,pz,x\n8,Anna,0,0,0,9\n8,AAB,5,0,0,9\n8,ABA,0,7,0,9\n";
  const auto stages =
      compared(text, balls(), {.columns = {{"cells", "n"}, {"name", "who"}, {"x", "px"}, {"y", "py"}, {"z", "pz"}}});
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].rmsd.value() < 1e-13);
}

TEST_CASE("tracks are compared at their numbers of cells") {
  std::string text = "track_id,t,z,y,x,parent_track_id,name\n";
  for (std::size_t i = 0; i < restPlaces.size(); ++i) {
    const Point p = turned(restPlaces[i]);
    for (int t = 0; t < 3; ++t)
      text += fmt::format("{},{},{:.17g},{:.17g},{:.17g},,{}\n", i + 1, t, p.z, p.y, p.x, pathOf(i));
  }
  const auto stages = compared(text);
  REQUIRE(stages.size() == 1);
  CHECK(stages[0].ofCells == 8);
  CHECK(stages[0].rmsd.value() < 1e-12);
}

TEST_CASE("contacts are compared with those that a table lists") {
  // Three balls in a row, each touching the next; the table has one of these contacts, and one that is none.
  const Scenario row = readScenario(
      "morula: 1\nname: s\ndna: |\n  START: a0\n  g1(a0|a0)\ncycle: {length: 100}\nstop: {time: 0.1}\nphysics: {cell: "
      "{model: sphere}, drag: 1, contact: {stiffness: 1}}\ncells: [{at: [0, 0, 0]}, {at: [1.9, 0, 0]}, {at: [3.8, 0, "
      "0]}]\n",
      "s.yaml", "");
  const auto stages = compared("cells,path,x,y,z,contacts\n3,AA,0,0,0,AB B\n3,AB,1.9,0,0,\n3,B,3.8,0,0,AA\n", row);
  CHECK(stages[0].contactF1 == 0.5);  // 2·1 / (2 + 2)
  CHECK(stages[0].rmsd.value() < 0.1);
}

// `cells: {file: …}`: a table of start cells gives the scene that a list of the same cells gives.
#include "simulation/simulation.h"
#include "simulation/start_cells.h"
// Included last, because of CHECK:
#include "helpers.h"

using namespace morula;
using namespace morula::test;

namespace {

const std::string physics = "physics: {mesh: {icosphere: 1}, cell: {radius: 2}, contact: {}}\n";

std::string tableScene(const std::string& cells, const std::string& parts = physics) {
  return "morula: 1\nname: x\ndna: |\n  START: a0\n  g1(a0|a0)\n  g2(b1|a0)\n  g3(b1|b1)\nstop: {time: 1}\n" + parts +
         "cells: " + cells + "\n";
}

Scenario readTable(const std::string& table, const std::string& parts = physics) {
  const TemporaryFolder folder;
  writeText(folder / "cells.csv", table);
  return readScenario(tableScene("{file: cells.csv}", parts), "test.yaml", std::string(folder / ""), {});
}

std::string refusalOfTable(const std::string& table, const std::string& parts = physics) {
  return refusalOf([&] { readTable(table, parts); });
}

}  // namespace

TEST_CASE("A table of start cells gives the scenario that a list gives, to the hash") {
  const Scenario table = readTable(
      "\xEF\xBB\xBFname;x [um];POSITION_Y;z;radius;vx;vy;vz;mass;kind\r\n# a comment\r\nleft;-2;0;0;1;0;0;0;;a0\r\n"
      "right;2;0.5;0;2;-1;0;0;3;b1 a0\r\n");
  const Scenario list = read(
      tableScene("[{at: [-2, 0, 0], scale: 0.5, substances: [a0]}, {at: [2, 0.5, 0], velocity: [-1, 0, 0], mass: 3, "
                 "substances: [a0, b1]}]\nnames: {cells: {A: left, B: right}}"));
  CHECK(table.resolved == list.resolved);
  CHECK(table.meaning == list.meaning);
  CHECK(table.names.of(CellPath::parse("B")) == "right");
  CHECK(makeWorld(table.scene).cells.path.size() == 2);
  // The resolved scenario needs no table.
  CHECK(readScenario(table.resolved, "resolved.yaml", "", {}).meaning == table.meaning);
}

TEST_CASE("A volume is that of a ball, and an empty size or mass is the egg's") {
  const Scenario s = readTable("x,y,z,volume\n0,0,0,33.510321638291124\n9,0,0,\n");  // 4π/3 · 2³
  CHECK(s.scene.cells[0].scale == Approx(1).epsilon(1e-15));
  CHECK(readTable("x y z\n0 0 0\n9 0 0\n").scene.cells[1].scale == 1);
}

TEST_CASE("Founders without bodies need no places") {
  const Scenario s = readTable("name,kind\nP,a0\nQ,b1\nR,a0\n", "");
  const World world = makeWorld(s.scene);
  CHECK(world.cells.path == founderPaths(3));
  CHECK(world.biology->describe(world.cells.state[1]) == "b1");
  CHECK(s.names.of(world.cells.path[2]) == "R");
}

TEST_CASE("A table of start cells that is wrong is refused with its line and the remedy") {
  const auto refused = [&](const std::string& table, const std::string& why) {
    CAPTURE(table);
    CHECK_THAT(refusalOfTable(table), Catch::Contains(why));
  };
  refused("", "there is no row; needs a header");
  refused("x,y,z\n", "there is no row");
  refused("x,y\n0,0\n", "there is no column z");
  refused("x,y,z,size\n0,0,0,1\n", "cells.csv:1:7: 'size' is no column of start cells");
  refused("x,y,z,X\n0,0,0,1\n", "two columns give the same: 'x' and 'X'");
  refused("x,y,z,radius,volume\n0,0,0,1,1\n", "keep one of them");
  refused("x,y,z\n0,0\n", "cells.csv:2:1: the row has 2 fields, and the header 3");
  refused("x,y,z\n0,nan,0\n", "cells.csv:2:3: 'nan' is no y");
  refused("x;y;z\n0;1,5;0\n", "'1,5' is no y; needs a number, with a point");
  refused("x,y,z,radius\n0,0,0,-1\n", "'-1' is no radius; needs a number > 0");
  refused("x,y,z,radius\n0,,0,1\n", "there is no y; fill it in");
  refused("x,y,z,kind\n0,0,0,a9\n", "the DNA has no substance 'a9'");
  refused("x,y,z,kind\n0,0,0,a0+a0\n", "'a0' is given twice");
  refused("x,y,z,name\n0,0,0,=A\n", "'=A' is no name of a cell");
  refused("x,y,z,name\n0,0,0,A\n9,0,0,A\n", "'A' is also the name of");
  refused("\xFF\xFEx", "the file is UTF-16");
  CHECK_THAT(complaints(tableScene("{file: none.csv}")), Catch::Contains("cells.file"));
  CHECK_THAT(complaints(tableScene("[{scale: 1}]")), Catch::Contains("cells[0].at: is missing"));
}

// The library's simulator, for other programs, gives the results of the world inside.
#include "catch.h"
#include "library/morula.h"
#include "library/scene_format.h"
#include "observation/measures.h"
#include "scenes.h"
#include "state/state_hash.h"

#ifdef __SSE2__
#include <xmmintrin.h>
#endif

using namespace morula;

namespace {

const DataColumn& columnNamed(const DataTable& table, const std::string& name) {
  for (const DataColumn& column : table.columns)
    if (column.name == name) return column;
  throw std::runtime_error("no column " + name);
}

Scene shortLife() {
  Scene scene = scenes::life();
  scene.stop.time = 3;
  return scene;
}

}  // namespace

TEST_CASE("A simulator goes the way of its world, in whatever portions, with whatever threads") {
  World world = makeWorld(shortLife());
  Simulator one(writeScene(shortLife())), two(writeScene(shortLife()), 2);
  CHECK(one.hash() == stateHash(world).text());
  CHECK(one.end() == plannedEnd(world.model));
  while (!finished(world)) step(world);
  while (!one.finished()) one.step();
  two.step(7);
  CHECK(two.steps() == 7);
  two.step(1'000'000'000);
  CHECK(two.finished());
  CHECK(one.hash() == stateHash(world).text());
  CHECK(two.hash() == one.hash());
  CHECK(one.steps() == world.clock.step);
  CHECK(one.now() == world.clock.time);
  two.step();
  CHECK(two.hash() == one.hash());
}

TEST_CASE("It tells of cells and measures") {
  World world = makeWorld(shortLife());
  Simulator organism(writeScene(shortLife()));
  while (!finished(world)) step(world);
  organism.step(world.clock.step);
  REQUIRE(organism.cells() == world.cells.path.size());
  const auto cells = measureCells(world);
  for (std::size_t i = 0; i < organism.cells(); ++i) {
    CHECK(organism.path(i) == world.cells.path[i].text());
    CHECK(organism.substances(i) == world.biology->describe(world.cells.state[i]));
    const Mesh mesh = cellMesh(world, world.cells.path[i]);
    REQUIRE(organism.vertices(i).size() == 3 * mesh.vertices.size());
    CHECK(organism.vertices(i)[4] == mesh.vertices[1].y);
    CHECK(organism.faces(i).size() == 3 * mesh.faces.size());
    CHECK(organism.measure("volume", i) == cells[i]["volume"]);
  }
  for (const WorldMeasure& row : sampledMeasures<Observation>())
    CHECK(organism.measure(row.name) == measureWorld(world)[row.name]);
  CHECK(organism.measure("membrane_energy") ==
        takeMeasures(Observation(world), std::vector<std::string>{"membrane_energy"}).front().value);
}

TEST_CASE("What it is asked for and does not have is said") {
  Simulator organism(writeScene(scenes::lineageOnly(scenes::uniqueFour, 2)));
  CHECK(organism.vertices(0).empty());
  CHECK(organism.measure("volume", 0) == std::nullopt);
  CHECK_THROWS_WITH(organism.measure("weight"), ContainsSubstring("there is no measure 'weight' of the organism"));
  CHECK_THROWS_WITH(organism.measure("weight", 0), ContainsSubstring("there is no measure 'weight' of cells"));
  CHECK_THROWS_WITH(organism.path(5), ContainsSubstring("there is no cell 5; 1 are alive"));
  CHECK_THROWS_AS(organism.column("weight"), InputError);
  CHECK_THROWS_WITH(organism.table("cells"), ContainsSubstring("there is no table 'cells'; needs one of cell, sample"));
  CHECK_THROWS_AS(organism.restore("no state"), InputError);
  CHECK_THROWS_WITH(Simulator("morula: 1"), ContainsSubstring("scene:1: the text is no scene"));
}

TEST_CASE("A saved state goes on with the same bits, also in another simulator") {
  Simulator one(writeScene(shortLife())), two(writeScene(shortLife()));
  one.runUntil(1.5);
  CHECK(one.now() >= 1.5);
  const std::string hash = one.hash(), state = one.save();
  one.runUntil(1e9);
  CHECK(one.finished());
  two.restore(state);
  CHECK(two.hash() == hash);
  two.runUntil(1e9);
  CHECK(two.hash() == one.hash());
  one.restore(state);
  CHECK(one.hash() == hash);
  CHECK_THROWS_AS(Simulator(writeScene(scenes::lineageOnly(scenes::uniqueFour, 2))).restore(state), InputError);
}

TEST_CASE("Tables and columns are those of the world, and measured anew after a step") {
  Simulator organism(writeScene(shortLife()));
  organism.runUntil(2.5);
  const DataTable cells = organism.table("cell_sample"), lineage = organism.table("cell");
  REQUIRE(columnNamed(cells, "path").texts.size() == organism.cells());
  CHECK(cells.columns.front().name == "time");
  CHECK(columnNamed(cells, "volume").unit == "length³");
  CHECK(columnNamed(cells, "volume").numbers == organism.column("volume"));
  CHECK(columnNamed(cells, "path").texts[0] == organism.path(0));
  CHECK(columnNamed(lineage, "parent").texts[0] == std::nullopt);
  CHECK(columnNamed(lineage, "path").texts[0] == "");
  CHECK(columnNamed(lineage, "born_step").kind == DataColumn::Kind::whole);
  CHECK(columnNamed(organism.table("division"), "axis_x").numbers.size() + 1 == organism.cells());
  CHECK(columnNamed(organism.table("sample"), "step").numbers[0] == double(organism.steps()));
  const auto before = organism.column("pressure");
  organism.step(16);
  CHECK(organism.column("pressure") != before);
  bool known = false;
  for (const MeasureInfo& m : Simulator::measures()) known = known || (m.name == "volume" && m.ofCells);
  CHECK(known);
}

#ifdef __SSE2__
TEST_CASE("The caller's rounding is given back, and changes nothing") {
  Simulator one(writeScene(shortLife())), two(writeScene(shortLife()));
  one.runUntil(1);
  const unsigned before = _mm_getcsr(), toZero = before | 0x8040 | 0x6000;  // flushes denormals, rounds towards zero
  _mm_setcsr(toZero);
  two.runUntil(1);
  const double volume = *two.measure("volume");
  const unsigned after = _mm_getcsr();
  _mm_setcsr(before);
  CHECK((after & ~0x3fu) == (toZero & ~0x3fu));  // but for flags of what has happened
  CHECK(two.hash() == one.hash());
  CHECK(volume == *one.measure("volume"));
}
#endif

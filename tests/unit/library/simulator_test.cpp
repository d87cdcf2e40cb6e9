// The library's simulator, for other programs, gives the results of the world inside.
#include "catch.h"
#include "library/morula.h"
#include "library/scene_format.h"
#include "observation/measures.h"
#include "scenes.h"
#include "state/state_hash.h"

using namespace morula;

namespace {

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
  CHECK_THROWS_WITH(Simulator("morula: 1"), ContainsSubstring("scene:1: the text is no scene"));
}

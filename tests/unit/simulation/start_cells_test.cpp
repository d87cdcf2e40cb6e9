// Several cells at time 0.
#include "base/error.h"
#include "catch.h"
#include "simulation/restore.h"
#include "state/start_cell.h"
#include "worlds.h"

using namespace morula;

namespace {

const std::string restAndDivide = "START: rest\ng1(rest|rest)\ng2(go|go)\ng3(divide|go)\ng4(other|go)\n";

Scene withCells(std::vector<StartCell> cells) {
  Scene s = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1);
  s.cells = std::move(cells);
  return s;
}

StartCell at(double x) { return {.at = {x, 0, 0}}; }

}  // namespace

TEST_CASE("One start cell like the egg is the egg, bit for bit") {
  const Scene egg = scenes::packed();
  Scene one = egg;
  one.cells = {StartCell{}};
  World a = makeWorld(egg), b = makeWorld(one);
  CHECK(stateHash(a) == stateHash(b));
  for (int i = 0; i < 20; ++i) step(a), step(b);
  CHECK(stateHash(a) == stateHash(b));
}

TEST_CASE("Paths are those of an egg that divided at time 0, in the order of the list") {
  const std::vector<std::vector<std::string>> expected{
      {""}, {"A", "B"}, {"AA", "AB", "B"}, {"AA", "AB", "BA", "BB"}, {"AAA", "AAB", "AB", "BA", "BB"}};
  for (const auto& paths : expected) {
    std::vector<StartCell> cells;
    for (std::size_t i = 0; i < paths.size(); ++i) cells.push_back(at(3.0 * static_cast<double>(i)));
    const World world = makeWorld(withCells(cells));
    CHECK(pathsOf(world) == paths);
    for (std::size_t i = 0; i < paths.size(); ++i) CHECK(norm(centreOf(world, paths[i].c_str()) - cells[i].at) < 1e-12);
    // The lineage is a whole tree: every mother divided at time 0, before her daughters.
    REQUIRE(world.lineage.entries.size() == 2 * paths.size() - 1);
    std::size_t divided = 0;
    for (std::size_t i = 0; i < world.lineage.entries.size(); ++i) {
      const LineageEntry& e = world.lineage.entries[i];
      divided += e.fate == Fate::divided;
      CHECK((e.born == 0 && e.ended == 0 && e.endedStep == 0));
      if (i > 0) CHECK(world.lineage.entries[i - 1].path < e.path);
    }
    CHECK(divided == paths.size() - 1);
    for (std::size_t i = 0; i < paths.size(); ++i)
      CHECK(world.lineage.entries[world.cells.entry[i]].path == world.cells.path[i]);
  }
}

TEST_CASE("A mesh is turned about an axis, and then stretched") {
  const double third = std::sqrt(1.0 / 3);
  const World world = makeWorld(withCells({{.at = {-3, 0, 0}, .turn = {0, 0, 90}, .stretch = {2, 1, 1}},
                                           {.at = {3, 0, 0}, .turn = {-120 * third, -120 * third, -120 * third}},
                                           {.at = {9, 0, 0}, .turn = {0, 0, 360}}}));
  const Mesh& egg = world.model.mechanics->mesh;
  for (int v = 0; v < world.bodies->vertexCount(); ++v) {
    // Tolerances allow a few roundings: coordinates are 5 at most in the first two cells and 10 in the third.
    const Point& x = egg.vertices[v];
    CHECK(norm(world.bodies->vertex(0, v) - Point{-3 - 2 * x.y, x.x, x.z}) < 2e-15);
    CHECK(norm(world.bodies->vertex(1, v) - Point{3 + x.y, x.z, x.x}) < 2e-15);
    CHECK(norm(world.bodies->vertex(2, v) - Point{9 + x.x, x.y, x.z}) < 4e-15);
  }
  CHECK(world.bodies->volume[1] == Approx(world.bodies->volume[2]).epsilon(1e-14));
}

TEST_CASE("Place, velocity, size, shape and mass arrive; a scaled cell is at rest as the egg is") {
  StartCell plain = at(-3), other{.at = {3, 1, 2}, .velocity = {1, 2, 3}, .scale = 0.5};
  StartCell flat{.at = {0, 5, 0}, .stretch = {2, 1, 0.25}, .mass = 7.0};
  const World world = makeWorld(withCells({plain, other, flat}));
  const Bodies& b = *world.bodies;
  const Mesh& egg = world.model.mechanics->mesh;
  for (int v = 0; v < b.vertexCount(); ++v) {
    const Point& x = egg.vertices[v];
    CHECK(norm(b.vertex(1, v) - (other.at + 0.5 * x)) < 1e-15);
    CHECK(b.read(b.velocity, 1, v) == Vector{1, 2, 3});
    CHECK(norm(b.vertex(2, v) - Point{2 * x.x, 5 + x.y, 0.25 * x.z}) < 1e-15);
  }
  CHECK(b.mass(0) == Approx(1));
  CHECK(b.mass(1) == Approx(0.125));
  CHECK(b.mass(2) == Approx(7));
  CHECK(b.restScale[1] == 0.5);
  CHECK(b.restScale[2] == 1);
  CHECK(b.pressure[1] == Approx(b.pressure[0]).margin(1e-9));
  CHECK(b.volume[1] == Approx(b.volume[0] / 8));
  CHECK(b.volume[2] == Approx(b.volume[0] / 2));
  CHECK(b.pressureConstant[2] == b.pressureConstant[0]);
}

TEST_CASE("Start cells may be of other kinds, each with the pace of its kind") {
  Scene s = scenes::withBodies(restAndDivide, 3);
  s.cycle.perSubstance = {{"go", 0.25}};
  s.cells = {at(-2), at(2)};
  s.cells[1].substances = std::vector<std::string>{"go"};
  s.stop = {{}, 0.3, {}};
  CHECK(makeWorld(s).clock.nextCycle == 0.25);
  CHECK(pathsOf(ranToEnd(s)) == std::vector<std::string>{"A", "BA", "BB"});
  s.cells[1].substances = std::vector<std::string>{"unheard"};
  CHECK_THROWS_AS(makeWorld(s), InputError);
}

TEST_CASE("What began with several cells goes on from a checkpoint") {
  Scene s = scenes::packed();
  s.mechanics->physics.shell.reset();
  s.cells = {at(-1), at(1.1), at(9)};
  s.stop = {{}, 1.2, {}};
  World world = makeWorld(s);
  for (int i = 0; i < 30; ++i) step(world);
  World other = makeWorld(s);
  restoreState(other, saveState(world));
  runToEnd(world);
  runToEnd(other);
  CHECK(world.cells.path.size() == 6);
  CHECK(stateHash(world) == stateHash(other));
}

TEST_CASE("The parts of a scene are the same with and without start cells: a state goes on without them") {
  const Scene one = withCells({}), two = withCells({at(0), at(3)});
  World world = makeWorld(two), other = makeWorld(one);
  restoreState(other, saveState(world));
  CHECK(stateHash(world) == stateHash(other));
}

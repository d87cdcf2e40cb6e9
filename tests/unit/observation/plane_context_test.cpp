// Facts of a living world that division planes ask for.
#include "catch.h"
#include "observation/observation.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

/// Returns a world of balls at rest, with these radii and places.
World balls(const Scene& scene, const std::vector<std::pair<double, Point>>& places) {
  std::vector<Body> cells;
  for (const auto& [radius, at] : places) {
    Body body = shakenBody(scene.mechanics->mesh, 0, 0);
    for (Point& x : body.position) x = radius * x + at;
    body.restScale = radius;
    body.pressureConstant = 200 * radius * radius * radius;
    cells.push_back(body);
  }
  return worldOf(scene, cells);
}

Scene quiet() { return scenes::withBodies("START: a0\ng1(a0|a0)\n", 3); }

}  // namespace

TEST_CASE("the organism's centre is that of its volume") {
  const World world = balls(quiet(), {{2, {1, 0, 0}}, {1, {-8, 9, 0}}});  // volumes are 8 : 1
  const Observation now(world);
  CHECK(norm(now.cell(0).organismCentre() - Vector{0, 1, 0}) < 1e-12);
  CHECK(now.cell(1).organismCentre() == now.cell(0).organismCentre());
  CHECK(Observation(makeWorld(scenes::lineageOnly("START: a0", 1))).cell(0).organismCentre() == Point{});
}

TEST_CASE("the shell is known, or that there is none") {
  Scene scene = quiet();
  CHECK_FALSE(Observation(makeWorld(scene)).cell(0).shell());
  scene.mechanics->physics.shell = ShellParameters{{3, 2, 1}};
  CHECK(Observation(makeWorld(scene)).cell(0).shell() == Vector{3, 2, 1});
  CHECK_FALSE(Observation(makeWorld(scenes::lineageOnly("START: a0", 1))).cell(0).shell());
}

TEST_CASE("a cell knows whom it is connected to, by path") {
  Scene scene = quiet();
  scene.mechanics->connections = ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::plane, 0, {}};
  World world = balls(scene, {{1, {}}, {1, {9, 0, 0}}, {1, {0, 9, 0}}});
  const auto path = [&](int i) { return world.cells.path[i]; };
  connect(*world.connections, path(2), path(0), 0);
  connect(*world.connections, path(1), path(0), 0);
  const Observation now(world);
  const auto held = now.cell(0).connected();
  REQUIRE(held.size() == 2);
  CHECK(held[0] == &now.cell(1));
  CHECK(held[1] == &now.cell(2));
  CHECK(now.cell(2).connected().size() == 1);
  release(*world.connections, path(1), path(0), 1, ReleaseCause::gene);
  CHECK(Observation(world).cell(1).connected().empty());
  CHECK(Observation(makeWorld(quiet())).cell(0).connected().empty());
}

TEST_CASE("a polarity comes from the nearest ancestor that left one") {
  World world = makeWorld(quiet());
  world.cells.path[0] = CellPath::parse("ABBA");
  CHECK(Observation(world).cell(0).inheritedPolarity() == nullptr);
  world.polarities.emplace();
  CHECK(Observation(world).cell(0).inheritedPolarity() == nullptr);
  world.polarities = {{CellPath::parse(""), {1, 0, 0}},
                      {CellPath::parse("AB"), {0, 1, 0}},
                      {CellPath::parse("ABA"), {0, 0, 1}},
                      {CellPath::parse("ABBA"), {0, 0, 1}}};
  CHECK(*Observation(world).cell(0).inheritedPolarity() == Vector{0, 1, 0});
  world.cells.path[0] = CellPath::parse("B");
  CHECK(*Observation(world).cell(0).inheritedPolarity() == Vector{1, 0, 0});
}

TEST_CASE("in a run polarities turn and are inherited, and what is kept of them is sorted") {
  const World world = ranToEnd(scenes::turning());
  REQUIRE(world.polarities);
  const auto& kept = *world.polarities;
  REQUIRE(kept.size() == 3);  // polarities of the egg, A and B
  CHECK(kept[0].path.isEgg());
  CHECK(norm(kept[0].direction - Vector{1, 2, 3} / std::sqrt(14.0)) < 1e-14);
  CHECK(kept[1].path.text() == "A");
  CHECK(kept[1].direction == kept[0].direction);  // A holds a2 herself, and B does not
  CHECK(kept[2].path.text() == "B");
  CHECK(dot(kept[2].direction, kept[0].direction) > 0.9);  // A lies where the egg's polarity pointed
  CHECK_FALSE(kept[2].direction == kept[0].direction);
  CHECK_FALSE(ranToEnd(scenes::thesis()).polarities);
}

// Cells as spheres: the same worlds with one vertex per cell.
#include <algorithm>
#include <numbers>

#include "base/error.h"
#include "base/maths.h"
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

constexpr double pi = std::numbers::pi;

Vector velocityOf(const World& world, int cell) {
  return world.bodies->read(world.bodies->velocity, world.bodies->slots[cell], 0);
}

double distance(const World& world) {
  return norm(world.bodies->vertex(world.bodies->slots[1], 0) - world.bodies->vertex(world.bodies->slots[0], 0));
}

double radiusOf(const World& world, int cell) {
  return world.bodies->parameters.cell.radius * world.bodies->restScale[world.bodies->slots[cell]];
}

}  // namespace

// The relative motion has the reduced mass ½ on a spring K: depth u/ω sin ωt with ω² = 2K, for half a period.
TEST_CASE("Two spheres bounce as a spring between them does") {
  const double u = 2, omega = std::sqrt(60.0), meet = 1.0 / u;
  World world =
      makeWorld(looseBalls({{.at = {-1.5, 0, 0}, .velocity = {1, 0, 0}}, {.at = {1.5, 0, 0}, .velocity = {-1, 0, 0}}}));
  double worst = 0, deepest = 0;
  while (world.clock.time < 2 * meet + pi / omega) {
    step(world);
    const double t = world.clock.time - meet;
    const double expected = t <= 0            ? 2 - u * t
                            : t <= pi / omega ? 2 - u / omega * std::sin(omega * t)
                                              : 2 + u * (t - pi / omega);
    worst = std::max(worst, std::abs(distance(world) - expected));
    deepest = std::max(deepest, 2 - distance(world));
  }
  CHECK(worst < 2e-5);  // second order in a step of 2^-10, and up to one step after the meeting: ω²u Δt²/2 = 6e-5
  CHECK(std::abs(deepest - u / omega) < 1e-5);
  CHECK(std::abs(velocityOf(world, 1).x - 1) < 2e-4);
  CHECK(velocityOf(world, 0) == -velocityOf(world, 1));  // exact to the bit
}

TEST_CASE("A crowd of spheres keeps its momentum to rounding, and each its size and mass") {
  std::vector<StartCell> cells;
  for (int i = 0; i < 27; ++i)
    cells.push_back({.at = Vector{1.7 * (i % 3), 1.7 * (i / 3 % 3), 1.7 * (i / 9)},
                     .velocity = 0.5 * noiseVector(static_cast<std::uint32_t>(i), 1),
                     .scale = 0.8 + 0.02 * i});
  Scene scene = looseBalls(cells);
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  World world = makeWorld(scene);
  const Vector before = momentumOf(*world.bodies);
  for (int i = 0; i < 2000; ++i) step(world);
  CHECK(norm(momentumOf(*world.bodies) - before) < 1e-12);
  CHECK(world.contacts->pairEvaluations > 10000);
  for (int i = 0; i < 27; ++i) {
    const double r = 0.8 + 0.02 * i;
    CHECK(std::abs(world.bodies->volume[world.bodies->slots[i]] - 4 * pi / 3 * r * r * r) < 1e-13 * r);
  }
}

TEST_CASE("A sphere's medium, measures and surface are those of a ball") {
  Scene scene = looseBalls({{.at = {3, 2, 1}, .velocity = {1, 0, 0}, .scale = 0.5}});
  scene.mechanics->physics.drag = 4;
  const World world = ranTo(scene, 0.5);
  CHECK(std::abs(velocityOf(world, 0).x - std::exp(-2.0)) < 2e-6);  // error of second order in drag·Δt: 16·2^-20/6
  const CellMeasures m = measureCells(world)[0];
  CHECK(m.at("volume") == Approx(4 * pi / 3 / 8).epsilon(1e-14));
  CHECK(m.at("area") == Approx(pi).epsilon(1e-14));
  CHECK(m.at("sphericity") == 1);
  CHECK_FALSE(m["pressure"]);
  const Mesh surface = cellMesh(world, world.cells.path[0]);
  REQUIRE(surface.vertices.size() == 42);
  // A sphere is drawn as the tests' mesh of radius 0.95, at its scale.
  for (const Point& x : surface.vertices)
    CHECK(std::abs(norm(x - Point{m.at("x"), m.at("y"), m.at("z")}) - 0.475) < 1e-13);
}

TEST_CASE("Spheres divide into halves inside their outline, and part until they touch") {
  Scene scene = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a1|a1)\n", 8);
  scene.mechanics->physics.cell = {1, 3, CellModel::sphere};
  scene.mechanics->physics.drag = 20;  // without drag they fly on: deep overlap is a stiff spring
  scene.mechanics->contact = scenes::pairContact;
  scene.mechanics->division = {DivisionPlane::axis, {0, 0, 2}};
  World world = makeWorld(scene);
  while (world.cells.path.size() == 1) step(world);
  const double r = cubeRoot(0.5);
  CHECK(radiusOf(world, 0) == radiusOf(world, 1));
  CHECK(std::abs(radiusOf(world, 0) - r) < 1e-15);
  CHECK(centreOf(world, "A").z == Approx(1 - r).epsilon(1e-14));
  CHECK(centreOf(world, "B").z == Approx(r - 1).epsilon(1e-14));
  CHECK(world.bodies->mass(0) + world.bodies->mass(1) == 3);
  runToEnd(world);
  CHECK(distance(world) > 1.999 * r);  // the last of the way takes long
  CHECK(distance(world) < 2.3 * r);
}

TEST_CASE("No sphere leaves a spherical shell") {
  Scene scene = scenes::spheres();
  scene.mechanics->physics.shell = ShellParameters{{1, 1, 1}};
  World world = makeWorld(scene);
  double outermost = 0;
  while (!finished(world)) {
    step(world);
    for (int i = 0; i < world.bodies->count; ++i)
      outermost = std::max(outermost, norm(world.bodies->vertex(world.bodies->slots[i], 0)) + radiusOf(world, i));
  }
  CHECK(world.cells.path.size() == 16);
  CHECK(outermost < 1 + 1e-14);
  CHECK(outermost > 1 - 1e-9);  // some cells press against the shell
}

// The disc of spheres of radii 1 and ½ at distance 1.2 lies in the plane at (1.44 + 1 − 0.25)/2.4 = 0.9125.
TEST_CASE("Spheres touch over the disc in which their surfaces meet") {
  World world = makeWorld(looseBalls({{.at = {0, 0, 0}}, {.at = {0, 1.2, 0}, .scale = 0.5}, {.at = {9, 0, 0}}}));
  const auto contacts = measureContacts(world);
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].at("area") == Approx(pi * (1 - 0.9125 * 0.9125)).epsilon(1e-9));
  const auto cells = measureCells(world);
  CHECK((cells[0].at("neighbours") == 1 && cells[1].at("neighbours") == 1 && cells[2].at("neighbours") == 0));
}

TEST_CASE("Two spheres with one centre stay finite") {
  World world = makeWorld(looseBalls({{.at = {0, 0, 0}}, {.at = {0, 0, 0}}}));
  for (int i = 0; i < 100; ++i) step(world);
  CHECK(distance(world) == 0);
}

TEST_CASE("A sphere costs a vertex: no mesh, no rings, no springs") {
  const World world = ranToEnd(scenes::spheres());
  CHECK(world.bodies->livingVertices == 16);
  CHECK(world.bodies->lineCount() == 2);
  CHECK(world.bodies->scratch[0].coefficient.size() == blockLanes);
}

TEST_CASE("Where nothing limits it, an automatic time step is refused") {
  Scene scene = looseBalls({});
  scene.mechanics->physics.timeStep.reset();
  scene.mechanics->contact.reset();
  CHECK_THROWS_AS(makeWorld(scene), InputError);
  CHECK_THROWS_WITH(
      makeWorld(scene),
      "physics.time_step: auto follows stability limits, and this scene has none; give physics.time_step a number");
}

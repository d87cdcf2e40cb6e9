// Two cells at rest, pressed together by a load F, the constant pull of a connection [Nilsson 2008, eq. 4.9].
//
//   spheres   overlap by F/K
//   shells    share a disc of area A on which contents press with F: at its rim the membrane lies in its plane and
//             bears nothing. The pull is spread over the whole cell, so the disc's own share of it counts
//             too: F = P A + F A/S, with S the cell's whole surface.
#include <numbers>

#include "catch.h"
#include "contacts/pair_energy.h"
#include "simulation/move_physics.h"
#include "worlds.h"

using namespace morula;

namespace {

World pressedTogether(CellModel model, int level, double load, double stiffness, double distance) {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\n", 1, makeIcosphere(level));
  PhysicsParameters& p = scene.mechanics->physics;
  p.cell.model = model;
  p.pressure = {8, 0};
  p.drag = 8;
  if (model == CellModel::sphere) p.timeStep = 0x1p-7;
  scene.mechanics->contact = ContactParameters{ContactLaw::pair, stiffness, 0.02, 0, 0.01, 1};
  scene.mechanics->connections = ConnectionParameters{};
  scene.mechanics->connections->strength = load;
  std::vector<Body> cells;
  for (const double side : {-0.5, 0.5}) {
    World alone = makeWorld(scene);
    Body body = takeBody(*alone.bodies, 0);
    for (Point& x : body.position) x.x += side * distance;
    cells.push_back(body);
  }
  World world = worldOf(scene, cells);
  connect(*world.connections, world.cells.path[0], world.cells.path[1], 0);
  evaluateForces(world);
  return world;
}

void comeToRest(World& world, double speed) {
  do {
    for (int i = 0; i < 100; ++i) step(world);
    REQUIRE(world.clock.step < 200'000);
  } while (fastestVertex(*world.bodies) > speed);
}

/// Returns the area (a third of adjacent faces) of the first cell's vertices pressed with at least half the pressure.
double pressedArea(const World& world, double pressure) {
  const Bodies& b = *world.bodies;
  std::vector<double> around(b.vertexCount(), 0.0);
  for (const Face& f : b.mesh.mesh.faces) {
    const Vector normal = cross(b.vertex(0, f[1]) - b.vertex(0, f[0]), b.vertex(0, f[2]) - b.vertex(0, f[0]));
    for (int v : f) around[v] += norm(normal) / 6;
  }
  double area = 0;
  for (const PairSum& p : sumPairs(*world.contacts, b)) {
    const int v = p.vertex / blockLanes;
    if (p.slot == 0 && p.pressing > 0.5 * pressure * around[v]) area += around[v];
  }
  return area;
}

}  // namespace

TEST_CASE("Two spheres under a load overlap by load over stiffness") {
  for (const double load : {0.1, 0.7}) {
    World world = pressedTogether(CellModel::sphere, 1, load, 30, 1.99);
    comeToRest(world, 1e-13);  // a speed of s means a distance of about s · drag · mass / K from rest
    const double distance = norm(world.bodies->vertex(0, 0) - world.bodies->vertex(1, 0));
    CHECK(2 - distance == Approx(load / 30).epsilon(1e-10));
  }
}

TEST_CASE("Two shells under a load share a disc on which their pressure bears it") {
  for (const double load : {0.6, 1.0, 2.0}) {
    World world = pressedTogether(CellModel::shell, 3, load, 300, 2.1);
    comeToRest(world, 1e-5);
    const double pressure = world.bodies->pressure[0], surface = measureCells(world)[0].at("area");
    const auto radius = [](double area) { return std::sqrt(area / std::numbers::pi); };
    const double expected = radius(load / (pressure + load / surface)), found = radius(pressedArea(world, pressure)),
                 measured = radius(measureContactAreas(*world.contacts, *world.bodies).at(0).area);
    CAPTURE(load, pressure, surface, expected, found, measured);
    // The rim runs between vertices that are pressed and those that are not.
    CHECK(std::abs(found - expected) < 0.25 * world.bodies->mesh.meanRestLength);
    CHECK(std::abs(measured - expected) < 0.25 * world.bodies->mesh.meanRestLength);
    CHECK(expected > 2 * world.bodies->mesh.meanRestLength);
  }
}

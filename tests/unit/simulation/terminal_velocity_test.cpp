// Two connected cells pull each other through a medium with a constant force [Nilsson 2008, eq. 4.9]. They approach the
// speed at which drag balances the force, v = k_c/(drag m) (1 − e^(−drag t)).
#include "catch.h"
#include "simulation/move_physics.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("A cell that is pulled through the medium approaches its terminal velocity as the formula says") {
  for (Integrator integrator : {Integrator::velocityVerlet, Integrator::rungeKutta4}) {
    Scene scene = scenes::withBodies(scenes::uniqueFour, 1, makeIcosphere(1));
    PhysicsParameters& p = scene.mechanics->physics;
    p.integrator = integrator;
    p.drag = 4;
    p.timeStep = 0x1p-12;
    scene.mechanics->connections = ConnectionParameters{};
    World world = worldOf(scene, flyingCells(makeIcosphere(1), 2, 40, 0));
    for (int slot = 0; slot < 2; ++slot)
      for (int v = 0; v < world.bodies->vertexCount(); ++v)
        world.bodies->write(world.bodies->velocity, slot, v, {0, 0, 0});
    connect(*world.connections, world.cells.path[0], world.cells.path[1], 0);
    evaluateForces(world);
    for (double time : {0.125, 0.5, 3.0}) {
      runTo(world, time);
      for (int slot = 0; slot < 2; ++slot) {
        const double expected = 0.2 / (4 * world.bodies->mass(slot)) * (1 - std::exp(-4 * time));
        CAPTURE(static_cast<int>(integrator), time, slot);
        const Vector velocity = momentumOf(*world.bodies, slot) / world.bodies->mass(slot);
        CHECK(norm(velocity) == Approx(expected).epsilon(1e-5));
        CHECK(velocity.x * (slot == 0 ? 1 : -1) > 0.99 * expected);
      }
    }
  }
}

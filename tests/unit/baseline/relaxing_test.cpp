// One cell that swings: Bullet's integrator is the thesis' Verlet, so the two may be held against each other
// vertex by vertex, and for long.
#include "baseline/bullet_world.h"
#include "catch.h"
#include "lab.h"
#include "simulation/measures.h"
#include "simulation/world.h"
#include "worst.h"

using namespace morula;

namespace {

/// Elongated and let go. The medium takes its swing, or else differences of one rounding would grow.
Scene relaxing(double timeStep, double time) {
  Scene scene;
  scene.name = "relaxing";
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "dna");
  scene.cycle.length = 1000;
  scene.stop.time = time;
  scene.mechanics.emplace();
  scene.mechanics->mesh = makeIcosphere(2);
  scene.mechanics->physics.timeStep = timeStep;
  scene.mechanics->physics.integrator = Integrator::thesisVerlet;
  scene.mechanics->physics.drag = 0.25;
  scene.mechanics->physics.pressure = {8, 0};
  scene.cells = {{.at = {}, .stretch = {1.1, 0.95, 0.95}}};
  return scene;
}

}  // namespace

TEST_CASE("B1 and the thesis' Verlet stay together for 8,000 steps") {
  NEEDS_BULLET
  World ours = makeWorld(relaxing(0x1p-8, 8000 * 0x1p-8));
  BulletScene scene;
  scene.mesh = ours.model.mechanics->mesh;
  scene.physics = ours.model.mechanics->physics;
  scene.cells = {takeBody(*ours.bodies, 0)};
  scene.timeStep = 0x1p-8;
  scene.contact = false;
  BulletWorld bullet(scene);
  Worst moved, apart;
  const std::vector<Point> start = scene.cells[0].position;
  while (!finished(ours)) {
    step(ours);
    bullet.step();
    if (ours.clock.step % 500 != 0) continue;
    const std::vector<Point> here = cellVertices(ours, ours.cells.path[0]),
                             there = bullet.cells()[0].position;
    for (std::size_t v = 0; v < here.size(); ++v) {
      moved.see(norm(here[v] - start[v]));
      apart.see(norm(here[v] - there[v]));
    }
  }
  CHECK(ours.clock.step == 8000);
  CHECK(moved > 0.05);
  CHECK(apart <= 1e-10);
}

// One oscillating cell. Bullet's step equals either Verlet, depending on its start and on the velocity that forces use,
// so runs agree vertex by vertex for long.
#include "catch.h"
#include "engines/bullet_world.h"
#include "lab.h"
#include "observation/measures.h"
#include "simulation/simulation.h"
#include "worst.h"

using namespace morula;

namespace {

/// Returns a scene of an elongated cell that is let go. Drag keeps differences of one rounding from growing.
Scene relaxing(double timeStep, double time, Integrator integrator) {
  Scene scene;
  scene.name = "relaxing";
  scene.dna = parseDna("START: a0\ng1(a0|a0)\n", "dna");
  scene.cycle.length = 1000;
  scene.stop.time = time;
  scene.mechanics.emplace();
  scene.mechanics->mesh = makeIcosphere(2);
  scene.mechanics->physics.timeStep = timeStep;
  scene.mechanics->physics.integrator = integrator;
  scene.mechanics->physics.drag = 0.25;
  scene.mechanics->physics.pressure = {8, 0};
  scene.cells = {{.at = {}, .stretch = {1.1, 0.95, 0.95}}};
  return scene;
}

BulletScene inBullet(const World& world) {
  BulletScene scene;
  scene.mesh = world.model.mechanics->mesh;
  scene.physics = world.model.mechanics->physics;
  scene.cells = {takeBody(*world.bodies, 0)};
  scene.timeStep = world.clock.timeStep;
  return scene;
}

/// Returns the largest distance between two places of one vertex. [length]
double farthest(const std::vector<Point>& a, const std::vector<Point>& b) {
  Worst apart;
  for (std::size_t v = 0; v < a.size(); ++v) apart.see(norm(a[v] - b[v]));
  return apart;
}

}  // namespace

TEST_CASE("B1 as the thesis' Verlet is symplectic Euler with our forces") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(2, Baseline::b1, 0.25);
  scene.physics.membrane.damping = 0.05;
  scene.physics.pressure.outside = 1;
  scene.timeStep = 0x1p-7;
  scene.physics.integrator = Integrator::thesisVerlet;
  const MeshTemplate mesh = makeTemplate(scene.mesh, scene.physics.membrane.springs);
  Body byHand = scene.cells[0];
  const auto world = makeBulletWorld(scene);
  for (int i = 0; i < 256; ++i) {
    world->step();
    stepByHand(scene, mesh, byHand, linearLaw);
  }
  const Body inBullet = world->cells()[0];
  CHECK(std::abs(meanRadius(byHand) - 1) > 0.01);  // the cell has moved
  CHECK(farthest(inBullet.position, byHand.position) <= 5e-14);
}

TEST_CASE("B1 and either Verlet stay together for 8,000 steps") {
  NEEDS_BULLET
  for (const Integrator integrator : {Integrator::thesisVerlet, Integrator::velocityVerlet}) {
    CAPTURE(static_cast<int>(integrator));
    World ours = makeWorld(relaxing(0x1p-8, 8000 * 0x1p-8, integrator));
    const auto bullet = makeBulletWorld(inBullet(ours));
    const std::vector<Point> start = bullet->cells()[0].position;
    Worst moved, apart;
    while (!finished(ours)) {
      step(ours);
      bullet->step();
      if (ours.clock.step % 500 != 0) continue;
      const std::vector<Point> here = cellVertices(ours, ours.cells.path[0]);
      moved.see(farthest(here, start));
      apart.see(farthest(here, bullet->cells()[0].position));
    }
    CHECK(ours.clock.step == 8000);
    CHECK(moved > 0.05);
    CHECK(apart <= 1e-10);
  }
}

TEST_CASE("B1 is of second order in the time step, and of first as the thesis' Verlet") {
  NEEDS_BULLET
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet}) {
    CAPTURE(static_cast<int>(integrator));
    const auto at = [&](int stepsInOne) {
      BulletScene scene = inBullet(makeWorld(relaxing(0x1p-8, 4, integrator)));
      scene.timeStep = 1.0 / stepsInOne;
      const auto bullet = makeBulletWorld(scene);
      for (int i = 0; i < 4 * stepsInOne; ++i) bullet->step();
      return bullet->cells()[0].position;
    };
    World exact = makeWorld(relaxing(0x1p-11, 4, Integrator::rungeKutta4));
    while (!finished(exact)) step(exact);
    const std::vector<Point> reference = cellVertices(exact, exact.cells.path[0]);
    const double coarse = farthest(at(128), reference), fine = farthest(at(512), reference);
    INFO("errors " << coarse << " at 1/128, " << fine << " at 1/512");
    const bool second = integrator == Integrator::velocityVerlet;
    CHECK(coarse / fine > (second ? 15 : 3.5));
    CHECK(coarse / fine < (second ? 17 : 4.6));
  }
}

TEST_CASE("B1's velocities are those of the time of its positions") {
  NEEDS_BULLET
  World ours = makeWorld(relaxing(0x1p-7, 1, Integrator::velocityVerlet));
  const auto bullet = makeBulletWorld(inBullet(ours));
  Worst apart, speed;
  while (!finished(ours)) {
    const Body here = takeBody(*ours.bodies, 0), there = bullet->cells()[0];
    for (std::size_t v = 0; v < here.velocity.size(); ++v) {
      speed.see(norm(here.velocity[v]));
      apart.see(norm(here.velocity[v] - there.velocity[v]));
    }
    step(ours);
    bullet->step();
  }
  CHECK(speed > 0.1);
  CHECK(apart <= 1e-12);
}

// Bullet against what can be known without it.
#include "engines/bullet_world.h"

#include "catch.h"
#include "lab.h"
#include "worst.h"

using namespace morula;

TEST_CASE("B1 as the thesis' Verlet is symplectic Euler with our forces") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(2, Baseline::b1, 0.25);
  scene.physics.membrane.damping = 0.05;
  scene.physics.pressure.outside = 1;
  scene.timeStep = 0x1p-7;
  scene.physics.integrator = Integrator::thesisVerlet;
  const MeshTemplate mesh = makeTemplate(scene.mesh, scene.physics.membrane.springs);
  Body byHand = scene.cells[0];
  BulletWorld world(scene);
  for (int i = 0; i < 256; ++i) {
    world.step();
    stepByHand(scene, mesh, byHand, linearLaw);
  }
  const Body inBullet = world.cells()[0];
  CHECK(std::abs(meanRadius(byHand) - 1) > 0.01);  // it did move
  Worst apart;
  for (std::size_t v = 0; v < byHand.position.size(); ++v) apart.see(norm(inBullet.position[v] - byHand.position[v]));
  CHECK(apart <= 5e-14);
}

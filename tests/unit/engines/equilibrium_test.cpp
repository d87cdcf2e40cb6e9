// Cells at rest in Bullet.
#include "catch.h"
#include "engines/bullet_world.h"
#include "lab.h"

using namespace morula;

namespace {

Body settle(const BulletScene& scene, int steps) {
  const auto world = makeBulletWorld(scene);
  for (int i = 0; i < steps; ++i) world->step();
  return world->cells()[0];
}

/// [radii] Radius at which pressurisedCell(3) rests with equal springs, as B3's are.
constexpr double restOfEqualSprings = 1.053101148;

/// Returns the radius at which a cell with this law rests, by stepByHand.
template <class Law>
double restRadius(BulletScene scene, const Law& law) {
  const MeshTemplate mesh = makeTemplate(scene.mesh, scene.physics.membrane.springs);
  Body cell = scene.cells[0];
  for (int i = 0; i < 3000; ++i) stepByHand(scene, mesh, cell, law);
  return meanRadius(cell);
}

/// Returns the radius extrapolated to Δt = 0: moving ends link by link stiffens links in proportion to Δt².
double limitOfSmallSteps(BulletScene scene, int steps) {
  const double coarse = meanRadius(settle(scene, steps));
  scene.timeStep /= 2;
  const double fine = meanRadius(settle(scene, 2 * steps));
  return (4 * fine - coarse) / 3;
}

}  // namespace

TEST_CASE("B1 rests where linear springs balance the gas, equal ones and weighted ones") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(3, Baseline::b1, 8);
  CHECK(meanRadius(settle(scene, 2500)) == Approx(restRadius(scene, linearLaw)).margin(1e-6));
  scene.physics.membrane.springs = Springs::equal;
  CHECK(meanRadius(settle(scene, 2500)) == Approx(restOfEqualSprings).margin(1e-6));
}

TEST_CASE("B2 rests where Bullet's own springs balance the gas: f = k_s l (l² − L0²)/(l² + L0²)") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(3, Baseline::b2, 8);
  const double byHand = restRadius(scene, bulletsLaw);
  scene.timeStep = 0x1p-9;
  CHECK(limitOfSmallSteps(scene, 2500) == Approx(byHand).margin(3e-4));
  // The linear law's radius lies outside of the tolerance above, so the test tells the laws apart.
  CHECK(std::abs(byHand - restRadius(scene, linearLaw)) > 6e-4);
}

TEST_CASE("B2 knows an outside pressure, and each cell's own rest lengths, mass and contents") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(2, Baseline::b2, 8);
  scene.physics.pressure.outside = 1.2;
  Body& cell = scene.cells[0];
  for (Point& x : cell.position) x = 0.5 * x;
  cell.restScale = 0.5, cell.mass = 0.125, cell.pressureConstant = 1;
  const double byHand = restRadius(scene, bulletsLaw);
  CHECK(byHand > 0.503);
  scene.timeStep = 0x1p-9;
  CHECK(limitOfSmallSteps(scene, 1500) == Approx(byHand).margin(3e-4));
}

TEST_CASE("B3 rests where linear springs balance the gas, also in large time steps") {
  NEEDS_BULLET
  BulletScene scene = pressurisedCell(3, Baseline::b3, 8);
  for (const double dt : {0x1p-7, 0x1p-5}) {
    INFO("time step " << dt);
    scene.timeStep = dt;
    CHECK(meanRadius(settle(scene, static_cast<int>(20 / dt))) == Approx(restOfEqualSprings).margin(1e-8));
  }
}

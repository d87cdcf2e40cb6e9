// Stability limits: below them an oscillation stays bounded, above them it explodes.
#include "physics/stability.h"

#include <limits>
#include <numbers>

#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

/// Returns true if a slightly shaken cell has not exploded after some thousand steps.
bool survives(const PhysicsParameters& p, const Mesh& mesh, double timeStep, int steps = 3000) {
  Body body = shakenBody(mesh, 1e-3, 0);
  body.mass = p.cell.mass;
  body.pressureConstant = p.pressure.constant;
  Lab lab(p, mesh, {body}, bestIsa());
  lab.start();
  for (int i = 0; i < steps; ++i) {
    lab.step(timeStep);
    if (!(lab.bodies.volume[0] > 0.3 && lab.bodies.volume[0] < 30)) return false;
  }
  return true;
}

/// Returns true if a slightly shaken cell keeps more than a tenth of its initial motion after a long time.
bool keepsSwinging(const PhysicsParameters& p, const Mesh& mesh, double timeStep) {
  Body body = shakenBody(mesh, 1e-4, 0);
  body.mass = p.cell.mass;
  Lab lab(p, mesh, {body}, bestIsa());
  const auto motion = [&](int steps) {
    Worst fastest;
    for (int i = 0; i < steps; ++i) {
      lab.step(timeStep);
      fastest.see(fastestVertex(lab.bodies));
    }
    return fastest;
  };
  lab.start();
  const Worst atFirst = motion(100);
  motion(8000);
  return !(motion(100) < 0.1 * atFirst);
}

StabilityLimits limitsOf(const PhysicsParameters& p, const Mesh& mesh) {
  return measureLimits(evaluated({p, mesh}).bodies, 0);
}
double spring(const PhysicsParameters& p, const Mesh& mesh) { return limitsOf(p, mesh).spring; }
double pressure(const PhysicsParameters& p, const Mesh& mesh) { return limitsOf(p, mesh).pressure; }

}  // namespace

TEST_CASE("The springs' limit is where explosions begin, for all integrators, with and without damping") {
  for (Integrator integrator :
       {Integrator::velocityVerlet, Integrator::thesisVerlet, Integrator::symplecticEuler, Integrator::rungeKutta4})
    for (double damping : {0.0, 0.05, 0.5, 2.0}) {
      const Mesh mesh = makeIcosphere(2);
      PhysicsParameters p = softCell();
      p.integrator = integrator;
      p.cell.mass = 2;
      p.membrane = {40, damping, 1.26, Springs::equal};
      p.pressure = {0.4, 0};
      const double limit = spring(p, mesh);
      CAPTURE(static_cast<int>(integrator), damping, limit);
      REQUIRE(limit < 0.5 * pressure(p, mesh));
      CHECK(survives(p, mesh, 0.8 * limit));
      CHECK_FALSE(survives(p, mesh, 1.2 * limit));
    }
}

TEST_CASE("Springs without stiffness have a limit by damping, and none without either") {
  const Mesh mesh = makeIcosphere(1);
  PhysicsParameters p = softCell();
  p.membrane = {0, 0.5, 1.26, Springs::equal};
  CHECK(spring(p, mesh) == Approx(2 * (1.0 / 42 / 6) / (2 * 0.5)).epsilon(1e-14));
  CHECK(contactLimit(Integrator::velocityVerlet, 0, 0, 1) == std::numeric_limits<double>::infinity());
}

TEST_CASE("Explicit Euler's limits are those of what damps, and 0 without drag") {
  const Mesh mesh = makeIcosphere(2);
  for (double drag : {20.0, 60.0})
    for (double damping : {0.0, 0.05}) {
      PhysicsParameters p = softCell();
      p.integrator = Integrator::explicitEuler;
      p.cell.mass = 2;
      p.membrane = {40, damping, 1.26, Springs::equal};
      p.pressure = {0, 0};  // no tension either: springs act alone
      p.drag = drag;
      const double limit = spring(p, mesh);
      CAPTURE(drag, damping, limit);
      // Springs do not stiffen as they swing, so an unstable cell swings on instead of exploding. The limit goes with
      // 1/ω² and is less sharp than the other integrators'.
      CHECK_FALSE(keepsSwinging(p, mesh, 0.8 * limit));
      CHECK(keepsSwinging(p, mesh, 1.4 * limit));
      p.drag = 0;
      CHECK(spring(p, mesh) == 0);
      CHECK(pressure(p, mesh) == 0);
    }
  PhysicsParameters p = softCell();
  p.integrator = Integrator::explicitEuler;
  p.membrane = {4, 0.01, 1.26, Springs::equal};
  p.pressure = {4000, 4000 / measureVolume(mesh.vertices, mesh.faces)};
  p.drag = 60;
  const double breathing = pressure(p, mesh);
  REQUIRE(breathing < 0.5 * spring(p, mesh));
  CHECK(survives(p, mesh, 0.8 * breathing));
  CHECK_FALSE(survives(p, mesh, 1.5 * breathing, 8000));
  CHECK(contactLimit(Integrator::explicitEuler, 30, 0.02, 1, 0) == 0);
  // γ/ω² = (C + drag m/10)/K
  CHECK(contactLimit(Integrator::explicitEuler, 30, 0.02, 1, 2) == Approx(0.22 / 30).epsilon(1e-12));
}

TEST_CASE("A damped oscillator's limits in closed form") {
  const auto limit = [](Integrator i, double k, double c, double m) { return contactLimit(i, k, c, 10 * m, 1e-300); };
  CHECK(limit(Integrator::rungeKutta4, 9, 0, 1) == Approx(std::sqrt(8.0) / 3).epsilon(1e-14));
  CHECK(limit(Integrator::rungeKutta4, 0, 2, 1) == Approx(2.785293563405282 / 2).epsilon(1e-12));
  CHECK(limit(Integrator::explicitEuler, 9, 0.6, 1) == Approx(0.6 / 9).epsilon(1e-14));
  CHECK(limit(Integrator::explicitEuler, 0, 2, 1) == Approx(1).epsilon(1e-14));
  CHECK(limit(Integrator::explicitEuler, 9, 10, 1) == Approx(2.0 / 9).epsilon(1e-14));  // z = −1 and −9
  CHECK(limit(Integrator::rungeKutta4, 9, 10, 1) == Approx(2.785293563405282 / 9).epsilon(1e-12));
}

TEST_CASE("The gas' limit is where the breathing explodes") {
  const Mesh mesh = makeIcosphere(2);
  const double volume = measureVolume(mesh.vertices, mesh.faces);
  PhysicsParameters p = softCell();
  p.membrane = {4, 0, 1.26, Springs::equal};
  p.pressure = {4000, 4000 / volume};
  for (Integrator integrator : {Integrator::velocityVerlet, Integrator::rungeKutta4}) {
    p.integrator = integrator;
    const double limit = pressure(p, mesh);
    REQUIRE(limit < 0.5 * spring(p, mesh));
    CHECK(survives(p, mesh, 0.8 * limit));
    CHECK_FALSE(survives(p, mesh, 1.3 * limit));
  }
}

TEST_CASE("Limits fall with the root of the mass") {
  const Mesh mesh = makeIcosphere(1);
  PhysicsParameters p = softCell();
  p.membrane.damping = 0;
  Body heavy = shakenBody(mesh, 0, 0), light = heavy;
  heavy.pressureConstant = light.pressureConstant = 4;
  light.mass = 0.25;
  const Lab lab = evaluated({p, mesh, {heavy, light}});
  const StabilityLimits one = measureLimits(lab.bodies, 0), quarter = measureLimits(lab.bodies, 1);
  CHECK(quarter.spring == Approx(one.spring / 2).epsilon(1e-14));
  CHECK(quarter.pressure == Approx(one.pressure / 2).epsilon(1e-14));
}

TEST_CASE("The pressure's limit of uneven meshes, few of whose vertices bear much of the surface") {
  Mesh lens;  // two cones on a ring of 32: 32 faces meet at each tip
  for (int k = 0; k < 32; ++k) {
    const double angle = 2 * std::numbers::pi * k / 32;
    lens.vertices.push_back({std::cos(angle), std::sin(angle), 0});
    lens.faces.push_back({k, (k + 1) % 32, 32});
    lens.faces.push_back({(k + 1) % 32, k, 33});
  }
  lens.vertices.push_back({0, 0, 0.5});
  lens.vertices.push_back({0, 0, -0.5});
  PhysicsParameters p = softCell();
  p.membrane = {4, 0, 1.26, Springs::equal};
  p.pressure = {4000, 4000 / measureVolume(lens.vertices, lens.faces)};
  const double limit = pressure(p, lens);
  REQUIRE(limit < 0.5 * spring(p, lens));
  CHECK(survives(p, lens, 0.8 * limit));
  CHECK_FALSE(survives(p, lens, 1.2 * limit));
}

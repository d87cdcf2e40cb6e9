// The limits of stability: below them an oscillation stays as it is, above them it explodes.
#include "physics/stability.h"

#include <limits>

#include "catch.h"
#include "lab.h"

using namespace morula;

namespace {

/// True if a slightly shaken cell has not exploded after some thousand steps.
bool survives(const PhysicsParameters& p, const Mesh& mesh, double timeStep) {
  Body body = shakenBody(mesh, 1e-3, 0);
  body.mass = p.cell.mass;
  body.pressureConstant = p.pressure.constant;
  Lab lab(p, mesh, {body}, bestIsa());
  lab.start();
  for (int i = 0; i < 3000; ++i) {
    lab.step(timeStep);
    if (!(lab.bodies.volume[0] > 0.3 && lab.bodies.volume[0] < 30)) return false;
  }
  return true;
}

double spring(const PhysicsParameters& p, const Mesh& mesh) {
  Lab lab(p, mesh);
  lab.evaluate();
  return measureLimits(lab.bodies, 0).spring;
}

double pressure(const PhysicsParameters& p, const Mesh& mesh) {
  Lab lab(p, mesh);
  lab.evaluate();
  return measureLimits(lab.bodies, 0).pressure;
}

}  // namespace

TEST_CASE("The springs' limit is where explosions begin, for either integrator, with and without damping") {
  for (Integrator integrator : {Integrator::velocityVerlet, Integrator::thesisVerlet})
    for (double damping : {0.0, 0.05, 0.5, 2.0}) {
      const Mesh mesh = makeIcosphere(2);
      PhysicsParameters p = softCell();
      p.integrator = integrator;
      p.cell.mass = 2;
      p.membrane = {40, damping, 1.26};
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
  p.membrane = {0, 0.5, 1.26};
  CHECK(spring(p, mesh) == Approx(2 * (1.0 / 42 / 6) / (2 * 0.5)).epsilon(1e-14));
  CHECK(contactLimit(Integrator::velocityVerlet, 0, 0, 1) == std::numeric_limits<double>::infinity());
}

TEST_CASE("The gas' limit is where the breathing explodes") {
  const Mesh mesh = makeIcosphere(2);
  const double volume = measureVolume(mesh.vertices, mesh.faces);
  PhysicsParameters p = softCell();
  p.membrane = {4, 0, 1.26};
  p.pressure = {4000, 4000 / volume};
  const double limit = pressure(p, mesh);
  REQUIRE(limit < 0.5 * spring(p, mesh));
  CHECK(survives(p, mesh, 0.8 * limit));
  CHECK_FALSE(survives(p, mesh, 1.3 * limit));
}

TEST_CASE("Limits fall with the root of the mass") {
  const Mesh mesh = makeIcosphere(1);
  PhysicsParameters p = softCell();
  p.membrane.damping = 0;
  Body heavy = shakenBody(mesh, 0, 0), light = heavy;
  heavy.pressureConstant = light.pressureConstant = 4;
  light.mass = 0.25;
  Lab lab(p, mesh, {heavy, light});
  lab.evaluate();
  const StabilityLimits one = measureLimits(lab.bodies, 0), quarter = measureLimits(lab.bodies, 1);
  CHECK(quarter.spring == Approx(one.spring / 2).epsilon(1e-14));
  CHECK(quarter.pressure == Approx(one.pressure / 2).epsilon(1e-14));
}

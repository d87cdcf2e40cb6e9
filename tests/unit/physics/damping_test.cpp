// Damping as a share of critical follows the masses of the moment: the bits of a constant of that size.
#include "physics/damping.h"

#include "catch.h"
#include "lab.h"
#include "physics/stability.h"

using namespace morula;

namespace {

PhysicsParameters damped(const Damping& damping, Integrator integrator = Integrator::velocityVerlet) {
  PhysicsParameters p = softCell();
  p.membrane.damping = damping;
  p.integrator = integrator;
  return p;
}

Damping shareOfCritical(double ratio) {
  Damping damping;
  damping.ratio = ratio;
  return damping;
}

}  // namespace

TEST_CASE("Each cell of a block is damped by its share of critical: the bits of a constant 2 ζ √(k m)") {
  const Mesh mesh = makeIcosphere(1);
  for (const Integrator integrator : {Integrator::velocityVerlet, Integrator::xpbd}) {
    std::vector<Body> cells;
    for (int i = 0; i < 5; ++i) {
      cells.push_back(shakenBody(mesh, 0.05, 1, i));
      cells.back().mass = 0.25 * (i + 1) * (i + 1) * 42;  // vertices of which √m is exact
      cells.back().pressureConstant = 4;
    }
    const Lab together = stepped(Lab(damped(shareOfCritical(0.2), integrator), mesh, cells, bestIsa()), 60, 0x1p-8);
    for (int i = 0; i < 5; ++i) {
      PhysicsParameters p = damped(shareOfCritical(0.2), integrator);
      const double constant = 2 * 0.2 * std::sqrt(p.membrane.stiffness) * (0.5 * (i + 1));
      const Lab alone = stepped(Lab(damped(constant, integrator), mesh, {cells[i]}, bestIsa()), 60, 0x1p-8);
      CHECK(alone.positions() == together.positions(i));
    }
  }
}

TEST_CASE("A share of critical damping keeps the limits of damping and stiffness in proportion, whatever the mass") {
  const Mesh mesh = makeIcosphere(1);
  const auto shortened = [&](const Damping& damping, double mass) {
    const auto limit = [&](const Damping& by) {
      Body body = shakenBody(mesh, 0, 0);
      body.mass = mass;
      return measureLimits(evaluated({damped(by), mesh, {body}}).bodies, 0).spring;
    };
    return limit(0) / limit(damping);
  };
  const double whole = shortened(shareOfCritical(0.1), 1);
  CHECK(whole > 1.1);
  CHECK(whole < 2);
  CHECK(shortened(shareOfCritical(0.1), 1e-4) == Approx(whole).epsilon(1e-12));
  CHECK(shortened(0.05, 1e-4) > 5 * shortened(0.05, 1));  // a constant binds small cells
}

TEST_CASE("A constant counts without a ratio, and a ratio in place of the constant") {
  Damping damping = 0.5;
  CHECK(damping.of(40, 2) == 0.5);
  CHECK(damping.acts());
  damping.ratio = 0.1;
  CHECK(damping.of(50, 2) == Approx(2).epsilon(1e-15));
  CHECK_FALSE(Damping(0).acts());
}

// Growth: contents and membrane together, at a constant relative rate.
#include "physics/growth.h"

#include "catch.h"
#include "lab.h"

using namespace morula;

TEST_CASE("A step of growth multiplies mass and gas by 1 + rate·Δt and lengths by its third") {
  const Mesh mesh = makeIcosphere(1);
  Body body = shakenBody(mesh, 0, 0);
  body.mass = 42;
  body.pressureConstant = 4;
  body.restScale = 2;
  Lab lab(softCell(), mesh, {body, body});
  grow(lab.bodies, 1, 0.5, 0.25);
  CHECK(lab.bodies.mass(0) == 42);
  CHECK(lab.bodies.pressureConstant[0] == 4);
  CHECK(lab.bodies.restScale[0] == 2);
  CHECK(lab.bodies.mass(1) == 42 * 1.125);
  CHECK(lab.bodies.pressureConstant[1] == 4 * 1.125);
  CHECK(lab.bodies.restScale[1] == Approx(2 * (1 + 0.125 / 3)).epsilon(1e-15));
}

TEST_CASE("A cell that grows to twice its contents rests at twice the volume; shrinking brings it back") {
  PhysicsParameters p = softCell();
  p.pressure = {4, 1};
  p.drag = 2;
  Lab lab(p, makeIcosphere(1));
  const auto settledVolume = [&] {
    lab.start();
    for (int i = 0; i < 4000; ++i) lab.step(0x1p-8);
    return lab.bodies.volume[0];
  };
  // Lengths grow with the third root of the contents and k_s stays, so tension per length falls by the third root. The
  // volume comes close to double, not exactly.
  const double before = settledVolume();
  const double mass = lab.bodies.mass(0);
  int steps = 0;
  for (; lab.bodies.mass(0) < 2 * mass; ++steps) {
    grow(lab.bodies, 0, 0.1, 0x1p-8);
    lab.step(0x1p-8);
  }
  const double after = settledVolume();
  CHECK(after == Approx(2 * before).epsilon(0.02));
  for (; steps > 0; --steps) {
    grow(lab.bodies, 0, -0.1, 0x1p-8);
    lab.step(0x1p-8);
  }
  CHECK(settledVolume() == Approx(before).epsilon(1e-3));
}

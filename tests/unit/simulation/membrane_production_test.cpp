// New membrane at division keeps the pressure near zero [Nilsson 2008, §4.2.4].
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

struct Pressures {
  double egg, birth, settled;
};

Pressures pressuresWith(double production) {
  Scene scene = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\n", 9, makeIcosphere(2));
  scene.mechanics->physics.membrane.areaFactor = production;
  scene.mechanics->physics.drag = 2;
  World world = makeWorld(scene);
  Pressures p{};
  while (world.cells.path.size() == 1) {
    p.egg = world.bodies->pressure[0];
    step(world);
  }
  p.birth = world.bodies->pressure[0];
  runTo(world, 5);
  p.settled = world.bodies->pressure[0];
  return p;
}

}  // namespace

TEST_CASE("At birth the pressure is the mother's, whatever the membrane") {
  for (double production : {1.0, 1.26, 1.5}) {
    const Pressures p = pressuresWith(production);
    CHECK(p.birth == Approx(p.egg).margin(1e-6));
  }
}

TEST_CASE("With production 1.26 the pressure stays near zero; with less it rises, with more it falls") {
  const double none = pressuresWith(1.0).settled, right = pressuresWith(1.26).settled,
               more = pressuresWith(1.5).settled;
  // Compared with the membrane's tension: k_s per length of about 0.3.
  CHECK(std::abs(right) < 0.1);
  CHECK(none > 2);
  CHECK(more < right + 1e-3);
  CHECK(none > 20 * std::abs(right));
}

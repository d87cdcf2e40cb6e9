// Single precision beside double: the same scene, to the digits of a float.
#include "catch.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("With floats, cells go the same way to six digits until they have touched for a while") {
  Scene scene = scenes::packed();
  World wide = makeWorld(scene), narrow = makeWorld(scenes::inSingle(scene));
  CHECK(wide.clock.timeStep == narrow.clock.timeStep);
  for (int i = 0; i < 20; ++i) step(wide), step(narrow);
  REQUIRE(wide.bodies->count == narrow.bodies->count);
  const double apart = farthestApart(wide, narrow);
  Worst volumes;
  for (int slot : wide.bodies->slots)
    volumes.see(std::abs(narrow.bodies->volume[slot] / wide.bodies->volume[slot] - 1));
  // Twenty steps, each rounded to 6e-8 of an extent of about 1, with forces rounded to 1e-7.
  CHECK(apart < 2e-5);
  CHECK(volumes < 2e-5);
  CHECK(apart > 0);  // the numbers are floats
}

TEST_CASE("With floats, a whole life has the same lineage, and cells of the same volume") {
  const Scene scene = scenes::packed();
  const World wide = ranToEnd(scene), narrow = ranToEnd(scenes::inSingle(scene));
  CHECK(pathsOf(wide) == pathsOf(narrow));
  double wideVolume = 0, narrowVolume = 0;
  for (int slot = 0; slot < wide.bodies->count; ++slot) {
    wideVolume += wide.bodies->volume[slot];
    narrowVolume += narrow.bodies->volume[slot];
  }
  // Rounding changes how cells tip in the crowd, and so their volume. In doubles, too: moving one vertex of the egg by
  // 1e-9 to 5e-9 makes the volume 2.998 to 3.014.
  CHECK(narrowVolume == Approx(wideVolume).epsilon(8e-3));
}

TEST_CASE("With floats, touching cells keep their momentum to the floats' rounding") {
  Scene scene = scenes::inSingle(scenes::withBodies(scenes::uniqueFour, 3));
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  World world = worldOf(scene, flyingCells(makeIcosphere(1), 8, 2.2, 1));
  const Vector before = momentumOf(*world.bodies);
  for (int i = 0; i < 300; ++i) step(world);
  CHECK(world.contacts->rebuilds > 3);
  // Expected: 8 · 42 · 300 roundings of 6e-8 in a speed of about 1, most of which cancel, over a mass of about 11.
  CHECK(norm(momentumOf(*world.bodies) - before) < 1e-4);
}

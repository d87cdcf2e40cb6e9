// Chaos, measured: how fast a difference in the last place grows.
#include "loop/twin_run.h"

#include "catch.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

TwinRun twins(const Scene& scene) {
  return runTwins(makeWorld(scene, {Isa::scalar, 1}), makeWorld(scene, {Isa::scalar, 1}));
}

/// Returns a scene of one cell that drag brings to rest, so that an error dies out.
Scene calm() {
  Scene s = scenes::withBodies("START: a0\ng1(a0|a0)\n", 4);
  s.mechanics->physics.drag = 5;
  return s;
}

}  // namespace

TEST_CASE("A calm cell forgets a last place; a crowd that divides does not") {
  const TwinRun quiet = twins(calm());
  CHECK((quiet.growth.empty() || quiet.growth.back().size < 1e-13));
  const TwinRun crowd = twins(scenes::packed());
  REQUIRE(crowd.growth.size() > 3);
  CHECK(crowd.growth.back().size > 1e-12);
}

TEST_CASE("Viscosity does not chatter: two daughters pressed together forget a last place") {
  Scene scene = scenes::packed();
  scene.stop.time = 1.75;  // the egg divides at 1
  scene.mechanics->contact = scenes::pairContactWithViscosity;
  scene.mechanics->physics.drag = 20;
  const TwinRun run = twins(scene);
  CHECK((run.growth.empty() || run.growth.back().size < 1e-11));
}

TEST_CASE("Growth is told in rising decades at rising steps, and ends with the undisturbed state") {
  const Scene scene = scenes::packed();
  const TwinRun run = twins(scene);
  for (std::size_t i = 1; i < run.growth.size(); ++i) {
    CHECK(run.growth[i].size > run.growth[i - 1].size);
    CHECK(run.growth[i].step >= run.growth[i - 1].step);
  }
  CHECK(run.end == stateHash(ranToEnd(scene)));
}

TEST_CASE("A twin that cannot go on is infinitely far away, and the undisturbed run goes on to its end") {
  Scene crushed = calm();
  crushed.mechanics->physics.pressure.outside = 1000;
  World alone = makeWorld(crushed, {Isa::scalar, 1});
  CHECK_THROWS_AS(runToEnd(alone), NumericalError);
  const TwinRun run = runTwins(makeWorld(calm(), {Isa::scalar, 1}), makeWorld(crushed, {Isa::scalar, 1}));
  CHECK(run.end == stateHash(ranToEnd(calm())));
  REQUIRE_FALSE(run.growth.empty());
  CHECK(run.growth.back().size == 1);
}

TEST_CASE("The distance is that of two runs side by side") {
  const Scene scene = scenes::packed();
  const TwinRun run = twins(scene);
  World a = makeWorld(scene, {Isa::scalar, 1}), b = makeWorld(scene, {Isa::scalar, 1});
  b.bodies->position[b.bodies->at(0, 0)] = std::nextafter(double(b.bodies->position[b.bodies->at(0, 0)]), 1e300);
  const GoldenGrowth& last = run.growth.back();
  double before = 0, after = 0;
  while (a.clock.step < last.step) {
    step(a), step(b);
    before = after, after = 0;
    for (std::size_t c = 0; c < a.cells.path.size(); ++c)
      for (int v = 0; v < a.bodies->vertexCount(a.bodies->slots[c]); ++v) {
        const Vector d = a.bodies->vertex(a.bodies->slots[c], v) - b.bodies->vertex(b.bodies->slots[c], v);
        after = std::max({after, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
      }
  }
  const double radius = scene.mechanics->physics.cell.radius;
  CHECK(before / radius < last.size);
  CHECK(after / radius >= last.size);
}

TEST_CASE("In single precision a last place is a float's") {
  Scene scene = scenes::packed();
  scene.mechanics->physics.precision = Precision::binary32;
  const TwinRun run = twins(scene);
  REQUIRE_FALSE(run.growth.empty());
  CHECK(run.growth[0].step <= 1);
  CHECK(run.growth.size() > 7);  // the first seven decades come at once
}

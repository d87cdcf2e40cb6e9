// Crawling cells: their speed is as given, and their directions come from the seed.
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

/// Returns a scene of cells that crawl and never meet.
Scene crawling(double speed, double persistence, CellModel model = CellModel::sphere) {
  Scene scene = scenes::withBodies("START: a0\n", 9);
  scene.mechanics->physics.cell.model = model;
  scene.mechanics->physics.drag = 20;
  scene.mechanics->physics.timeStep = 0x1p-8;
  scene.mechanics->physics.motility = MotilityParameters{speed, persistence};
  for (int i = 0; i < 9; ++i) scene.cells.push_back({.at = {5.0 * i, 0, 0}});
  return scene;
}

std::vector<Point> centres(const World& world) {
  std::vector<Point> all;
  for (int slot : world.bodies->slots) all.push_back(measureCentre(*world.bodies, slot));
  return all;
}

/// Returns each cell's displacement after `time`.
std::vector<Vector> ways(const Scene& scene, double time) {
  World world = makeWorld(scene);
  std::vector<Vector> all = centres(world);
  runTo(world, time);
  const std::vector<Point> now = centres(world);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = now[i] - all[i];
  return all;
}

}  // namespace

TEST_CASE("A cell alone crawls straight on with the given speed, until it turns") {
  for (const CellModel model : {CellModel::sphere, CellModel::shell})
    for (const Vector& way : ways(crawling(0.5, 2, model), 2)) CHECK(norm(way) == Approx(1).epsilon(0.05));
  // Over ten turns the squares of displacements add up: the mean distance is about √10 intervals.
  double sum = 0;
  for (const Vector& way : ways(crawling(0.5, 0.25), 2.5)) sum += dot(way, way) / 9;
  CHECK(sum == Approx(10 * 0.125 * 0.125).epsilon(0.6));
}

TEST_CASE("Cells crawl each its own way, another with another seed, and back after none") {
  Scene scene = crawling(0.5, 1);
  const auto first = ways(scene, 0.5);
  CHECK(ways(scene, 0.5) == first);
  Vector sum;
  for (const Vector& way : first) sum += way / norm(way);
  CHECK(norm(sum) < 7);  // the sum of nine unit vectors
  scene.seed = 99;
  const auto other = ways(scene, 0.5);
  for (std::size_t i = 0; i < first.size(); ++i) CHECK(norm(first[i] - other[i]) > 1e-3);
}

TEST_CASE("Whole bodies crawl: they are not pulled out of shape, and their time step stays") {
  Scene scene = crawling(0.5, 1, CellModel::shell), resting = scene;
  resting.mechanics->physics.motility.reset();
  scene.mechanics->physics.timeStep.reset(), resting.mechanics->physics.timeStep.reset();
  World world = makeWorld(scene), still = makeWorld(resting);
  CHECK(world.clock.timeStep == still.clock.timeStep);
  for (int i = 0; i < 50; ++i) takeSteps(world, 64), takeSteps(still, 1);
  CHECK(world.clock.step == 50);  // the world takes steps one by one
  for (int slot = 0; slot < 9; ++slot)
    CHECK(world.bodies->volume[slot] == Approx(still.bodies->volume[slot]).epsilon(1e-9));
}

TEST_CASE("A scene whose cells crawl uses its seed") {
  Scene scene = crawling(0.5, 1);
  CHECK(usesSeed(scene));
  scene.mechanics->physics.motility.reset();
  CHECK_FALSE(usesSeed(scene));
}

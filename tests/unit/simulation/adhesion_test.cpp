// Adhesion in a running world follows the substances that cells hold at the time, and changes how cells touch.
#include "catch.h"
#include "observation/energy.h"
#include "simulation/time_step.h"
#include "worlds.h"

using namespace morula;

namespace {

Scene sticking(const std::string& dna, AdhesionParameters adhesion) {
  Scene scene = scenes::withBodies(dna, 9);
  scene.mechanics->contact = scenes::pairContact;
  scene.mechanics->contact->adhesion = std::move(adhesion);
  scene.mechanics->physics.drag = 5;
  return scene;
}

/// Returns the work of adhesion W of two cells, as contacts use it.
double workOf(const World& world, int a, int b) {
  return workOfAdhesion(*world.contacts, world.bodies->slots[a], world.bodies->slots[b]);
}

struct HeldBy {
  double area = 0;  // [length²] contact area by measureContactAreas
  double held = 0;  // [force·length] work needed to part the cells
  friend bool operator==(const HeldBy&, const HeldBy&) = default;
};

/// Returns area and adhesion of two cells at `time`.
HeldBy heldBy(const Scene& scene, double time = 6) {
  const World world = ranTo(scene, time);
  const auto areas = measureContactAreas(*world.contacts, *world.bodies);
  return {areas.empty() ? 0 : areas[0].area, -measureEnergy(world).adhesion};
}

const std::string resting = "START: a0\ng1(a0|a0)\ng2(red|red)\ng3(red2|red2)\ng4(blue|blue)\n";

}  // namespace

TEST_CASE("The first pair that fits two cells counts, in either order; the default holds for the rest") {
  Scene scene = sticking(resting, {0.25, {{"red", "red", 1}, {"blue", "red*", 2}, {"red*", "red*", 3}}});
  double x = 0;
  for (const char* substance : {"red", "red2", "blue", "a0"})
    scene.cells.push_back({.at = {x += 5, 0, 0}, .substances = std::vector<std::string>{substance}});
  const World world = makeWorld(scene);
  const double expected[4][4] = {{1, 3, 2, 0.25}, {3, 3, 2, 0.25}, {2, 2, 0.25, 0.25}, {0.25, 0.25, 0.25, 0.25}};
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) {
      CAPTURE(a, b);
      CHECK(workOf(world, a, b) == expected[a][b]);
    }
}

TEST_CASE("Adhesion follows the substances that a cell holds after its cycle, with or without births") {
  Scene scene = sticking("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1, A)\ng4(a3|a1, B)\ng5(a4|a2)\ng6(a5|a3)\n",
                         {0, {{"a1", "a1", 1}, {"a2", "a3", 2}, {"a4", "a5", 3}}});
  World world = makeWorld(scene);
  std::vector<double> works;
  for (const double time : {1.5, 2.5, 3.5}) {
    runTo(world, time);
    works.push_back(workOf(world, 0, 1));
  }
  CHECK(works == std::vector<double>{1, 2, 3});
}

TEST_CASE("Stronger adhesion flattens cells more against each other") {
  const auto heldWith = [](AdhesionParameters adhesion) {
    Scene scene = sticking(resting, std::move(adhesion));
    for (const char* substance : {"red", "blue"})
      scene.cells.push_back(
          {.at = {scene.cells.empty() ? -0.96 : 0.96, 0, 0}, .substances = std::vector<std::string>{substance}});
    return heldBy(scene);
  };
  const HeldBy none = heldWith({0, {}}), little = heldWith({0.25, {}}), some = heldWith({1, {}}),
               more = heldWith({2, {}});
  // The area is computed as force over pressure. Both are small here, since only adhesion presses the cells together.
  // So the area shows only that the cells touch, and need not grow with W (3.1 at W = 1, 2.8 at W = 2). The area of
  // flat contact is held / W.
  CHECK(little.area > none.area + 0.1);
  CHECK(some.area > none.area + 0.1);
  CHECK(more.area > none.area + 0.1);
  CHECK(none.held == 0);
  CHECK(some.held / 1 > 1.1 * little.held / 0.25);  // 1.57, 1.85, 3.20
  CHECK(more.held / 2 > 1.2 * some.held / 1);
  CHECK(heldWith({0, {{"red", "blue", 2}}}) == more);  // equal bit for bit
  CHECK(heldWith({2, {{"blue", "red", 0}}}) == none);
}

TEST_CASE("Without crawling and drag, cells that stick keep their momentum") {
  Scene scene = sticking(resting, {2, {}});
  scene.mechanics->physics.drag = 0;
  scene.cells = {{.at = {-0.97, 0, 0}, .velocity = {0.2, 0.1, 0}}, {.at = {0.97, 0.2, 0}}};
  World world = makeWorld(scene);
  const Vector before = momentumOf(*world.bodies);
  runTo(world, 2);
  CHECK(norm(momentumOf(*world.bodies) - before) < 1e-12);
}

TEST_CASE("Spheres in contact overlap by the depth at which adhesion and stiffness balance") {
  // At rest 2πW R* = K depth, with R* = ½ for two balls of radius 1.
  Scene scene = sticking(resting, {1.5, {}});
  scene.mechanics->physics.cell = {1, 1, CellModel::sphere};
  scene.cells = {{.at = {-1.05, 0, 0}}, {.at = {1.05, 0, 0}}};  // apart, and within reach
  const World world = ranTo(scene, 9);
  const double distance = norm(centreOf(world, "A") - centreOf(world, "B"));
  CHECK(2 - distance == Approx(3.141592653589793 * 1.5 / 30).epsilon(1e-3));
}

TEST_CASE("The force between two adhering spheres changes with their distance no faster than time step limits assume") {
  for (const double scale : {1.0, 0.6}) {
    Scene scene = sticking(resting, {2, {}});
    scene.mechanics->physics.cell = {1, 1, CellModel::sphere};
    scene.mechanics->contact->stiffness = 0.001;  // repulsion is negligible
    const auto forceAt = [&](double distance) {
      scene.cells = {{}, {.at = {distance, 0, 0}, .scale = scale}};
      const World world = makeWorld(scene);
      const Bodies& b = *world.bodies;
      return b.mass(b.slots[0]) * b.read(b.acceleration, b.slots[0], 0).x;
    };
    scene.cells = {{}, {.at = {1 + scale, 0, 0}, .scale = scale}};
    const World world = makeWorld(scene);
    const double limit = adhesionStiffness(*world.contacts, *world.bodies);
    constexpr double step = 1e-4;
    double steepest = 0;
    for (double gap = -0.1; gap < 1; gap += 0.003) {
      const double distance = 1 + scale + gap;
      steepest = std::max(steepest, std::abs(forceAt(distance + step) - forceAt(distance - step)) / (2 * step));
    }
    CAPTURE(scale, steepest, limit);
    CHECK(steepest > 0);
    CHECK(steepest <= limit);
    if (scale == 1) CHECK(steepest > 0.95 * limit);  // equal spheres come near the limit
  }
}

TEST_CASE("Adhesion shortens the automatic time step: that of membranes, which fold, earlier than that of spheres") {
  const auto limitWith = [](double work, CellModel model = CellModel::shell) {
    Scene scene = sticking(resting, {work, {}});
    scene.mechanics->physics.cell.model = model;
    scene.cells = {{.at = {-0.96, 0, 0}}, {.at = {0.96, 0, 0}}};
    return timeStepLimit(makeWorld(scene));
  };
  CHECK(limitWith(0.0005) > 0.99 * limitWith(0));
  CHECK(limitWith(1) < 0.8 * limitWith(0));
  CHECK(limitWith(30) < 0.8 * limitWith(1));
  CHECK(limitWith(1, CellModel::sphere) == limitWith(0, CellModel::sphere));
  CHECK(limitWith(30, CellModel::sphere) < 0.8 * limitWith(0, CellModel::sphere));
}

TEST_CASE("Adhesion of strength 0 costs nothing, and changes no bit") {
  Scene none = scenes::packed(), zero = none;
  none.stop.time = zero.stop.time = 2.5;
  zero.mechanics->contact->adhesion = AdhesionParameters{0, {{"a*", "a*", 0}}};
  const World plain = ranToEnd(none), free = ranToEnd(zero);
  CHECK(free.contacts->pairEvaluations == plain.contacts->pairEvaluations);
  CHECK(farthestApart(plain, free) == 0);
  CHECK(plain.bodies->count > 1);
}

TEST_CASE("How far two sticky cells spread on each other depends on W, not on the mesh") {
  // Values at rest: icosphere 5 gives them to 2 %, whether attraction reaches 1.25 or 1.5 edges.
  struct Limit {
    double work, area, distance;
  };
  for (const Limit& limit : {Limit{0.5, 1.47, 1.682}, {1, 2.125, 1.497}, {2, 2.815, 1.277}})
    for (const int level : {2, 3, 4}) {
      if (level == 4 && limit.work != 1)
        continue;  // one work on the finest mesh: each takes as long as all coarser ones
      Scene scene = scenes::settling(scenes::withBodies(resting, 1, scaleToRadius(makeIcosphere(level), 1)));
      scene.mechanics->physics.pressure = {800, 166};
      scene.mechanics->physics.quasiStatic = {.drag = 40, .residual = 1e-5};  // 40: cells that do not overshoot
      scene.mechanics->contact = scenes::pairContact;
      scene.mechanics->contact->adhesion = AdhesionParameters{limit.work, {}};
      scene.cells = {{.at = {-1.02, 0, 0}}, {.at = {1.02, 0, 0}}};
      scene.stop = {.cycles = {}, .time = 0.5, .cells = {}};
      const World world = ranToEnd(scene);
      REQUIRE(world.settlings->back().residual <= 1e-5);
      const auto areas = measureContactAreas(*world.contacts, *world.bodies);
      CAPTURE(limit.work, level);
      REQUIRE(areas.size() == 1);
      CHECK(areas[0].area == Approx(limit.area).epsilon(0.05));
      CHECK(norm(measureCentroid(takeBody(*world.bodies, 0).position) -
                 measureCentroid(takeBody(*world.bodies, 1).position)) == Approx(limit.distance).epsilon(0.05));
    }
}

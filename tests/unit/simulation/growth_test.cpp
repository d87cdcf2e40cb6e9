// Cells grow or shrink if they want to, from one cell cycle to the next.
#include "catch.h"
#include "worlds.h"

using namespace morula;

TEST_CASE("grow and shrink act at the scene's rate, and where there is no growth block they do nothing") {
  for (const auto& [gene, sign] : {std::pair{"grow", 1.0}, std::pair{"shrink", -1.0}})
    for (bool withGrowth : {true, false}) {
      const std::string dna = std::string("START: a0\ng1(a0|a0)\ng2(") + gene + "|a0)\n";
      Scene scene = scenes::withBodies(dna, 9);
      if (withGrowth) scene.mechanics->physics.growth = GrowthParameters{0.25};
      scene.mechanics->physics.drag = 1;
      World world = makeWorld(scene);
      const double volume = world.bodies->volume[0];
      runTo(world, 1);
      CHECK(world.bodies->mass(0) == Approx(1).epsilon(1e-14));  // a cell begins to grow after its cycle
      runTo(world, 3);
      const double expected = withGrowth ? std::exp(sign * 0.25 * 2) : 1;
      CAPTURE(gene, withGrowth);
      CHECK(world.bodies->mass(0) == Approx(expected).epsilon(0.01));
      CHECK(world.bodies->pressureConstant[0] == Approx(200 * expected).epsilon(0.01));
      CHECK(world.bodies->volume[0] / volume == Approx(expected).epsilon(0.05));
      CHECK(world.cells.growth[0] == sign);
    }
}

TEST_CASE("A cell whose gene falls silent stops growing") {
  Scene scene = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(grow|a0)\n", 9);
  scene.mechanics->physics.growth = GrowthParameters{0.25};
  World world = ranTo(scene, 2);
  const double mass = world.bodies->mass(0);
  CHECK(mass > 1.2);
  runTo(world, 3);
  CHECK(world.bodies->mass(0) == mass);
}

TEST_CASE("Daughters go on as their mother wanted, until their own cycle") {
  Scene scene = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(grow|a0)\ng4(a1|a1)\n", 9);
  scene.mechanics->physics.growth = GrowthParameters{0.25};
  const World world = ranTo(scene, 1.9);
  REQUIRE(world.bodies->count == 2);
  CHECK(world.cells.growth == std::vector<double>{1, 1});
  CHECK(world.bodies->mass(0) == Approx(0.5 * std::exp(0.25 * 0.9)).epsilon(0.01));
}

TEST_CASE("The reach of contact grows with the cell, from cycle to cycle") {
  Scene scene = scenes::withBodies("START: a0\ng1(a0|a0)\ng2(grow|a0)\n", 9);
  scene.mechanics->physics.growth = GrowthParameters{0.25};
  scene.mechanics->contact = scenes::pairContact;
  World world = makeWorld(scene);
  const double before = world.contacts->radius[0];
  CHECK(before == Approx(world.bodies->mesh.meanRestLength).epsilon(1e-14));
  runTo(world, 3);
  CHECK(world.bodies->restScale[0] > 1.1);
  CHECK(world.contacts->radius[0] == Approx(before * world.bodies->restScale[0]).epsilon(0.01));
}

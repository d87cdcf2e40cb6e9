// cycle.first: at-birth. A daughter holds her own substances while she lives; without it, her mother's.
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

/// P0 divides into AB and P1, and P1 into EMS and P2; each cell keeps her substance until she divides.
const std::string worm =
    "START: P0\n"
    "d0(divide|P0, !A, !B)\nd1(divide|P1, !A, !B)\n"
    "ab(AB|P0, A)\np1(P1|P0, B)\nems(EMS|P1, A)\np2(P2|P1, B)\n"
    "k0(P0|P0, !A, !B)\nk1(AB|AB, !A, !B)\nk2(P1|P1, !A, !B)\nk3(EMS|EMS, !A, !B)\nk4(P2|P2, !A, !B)\n";

Scene wormScene() {
  Scene scene = scenes::lineageOnly(worm, 4);
  scene.cycle.first = FirstCycle::atBirth;
  scene.cycle.perSubstance = {{"P1", 0.75}};
  return scene;
}

}  // namespace

TEST_CASE("Genes that are read at birth give a daughter her own substance in the step of her birth") {
  World world = makeWorld(wormScene());
  step(world);
  CHECK(world.clock.time == 1);
  CHECK(statesOf(world) == std::vector<std::string>{"AB", "P1"});
  step(world);  // her own cycle length counts from her birth
  CHECK(world.clock.time == 1.75);
  CHECK(pathsOf(world) == std::vector<std::string>{"A", "BA", "BB"});
  CHECK(statesOf(world) == std::vector<std::string>{"AB", "EMS", "P2"});
  runToEnd(world);
  CHECK(statesOf(world) == std::vector<std::string>{"AB", "EMS", "P2"});
  // The lineage tells of each cell what she held last: the mothers before they divided.
  for (const LineageEntry& entry : world.lineage.entries)
    if (entry.fate == Fate::divided)
      CHECK(world.biology->describe(entry.state) == (entry.path.isEgg() ? "P0 divide" : "P1 divide"));
}

TEST_CASE(
    "Without the key a daughter holds her mother's substances until her first cycle, and hashes stay as they were") {
  Scene scene = wormScene();
  scene.cycle.first = FirstCycle::afterLength;
  World world = makeWorld(scene);
  step(world);
  CHECK(statesOf(world) == std::vector<std::string>{"A P0 divide", "B P0 divide"});
}

TEST_CASE("With bodies daughters have the states that they have without") {
  Scene scene = scenes::withBodies(worm, 3);
  scene.cycle = wormScene().cycle;
  const World bodies = ranToEnd(scene);
  Scene alone = scene;
  alone.mechanics.reset();
  const World lineage = ranToEnd(alone);
  CHECK(statesOf(bodies) == statesOf(lineage));
  CHECK(pathsOf(bodies) == pathsOf(lineage));
}

TEST_CASE("A sense at birth perceives the newborn") {
  Scene scene = scenes::withBodies("START: a, young\nd(divide|a, !A, !B)\ns(seen|young)\nk(a|a, !A, !B)\n", 1);
  scene.cycle.first = FirstCycle::atBirth;
  scene.senses = {{.substance = "young", .kind = SenseKind::age, .is = {.below = 0.5}}};
  const World world = ranToEnd(scene);
  REQUIRE(world.cells.path.size() == 2);
  for (const std::string& state : statesOf(world)) CHECK(state == "seen young");
}

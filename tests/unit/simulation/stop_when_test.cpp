// stop.when: a run ends at the first look at which a condition holds.
#include <cmath>

#include "catch.h"
#include "observation/observation.h"
#include "worlds.h"

using namespace morula;

namespace {

CellSelection cell(const char* path) { return {.kind = CellSelection::Kind::cell, .path = CellPath::parse(path)}; }
CellSelection substance(const char* name) { return {.kind = CellSelection::Kind::substance, .substance = name}; }

World ranUntil(Scene scene, const StopWhen& when, std::optional<double> every = {}) {
  scene.stop.when = {when};
  scene.stop.every = every;
  World world = makeWorld(scene);
  while (!finished(world)) takeSteps(world, 64);
  return world;
}

}  // namespace

TEST_CASE("A lineage stops when a cell is born, or so many cells of a kind live") {
  const Scene scene = scenes::lineageOnly(scenes::uniqueFour, 6);
  const World born = ranUntil(scene, {.event = StopEvent::born, .of = {cell("BA")}});
  CHECK(born.clock.time == 2);
  CHECK(born.stoppedBy == 0u);
  const World kind = ranUntil(scene, {.event = StopEvent::cells, .of = {substance("a4")}, .count = 1});
  CHECK(kind.clock.time == 3);
  const World many = ranUntil(scene, {.event = StopEvent::cells, .count = 3});
  CHECK(many.clock.time == 2);
  const World never = ranUntil(scene, {.event = StopEvent::cells, .count = 5});
  CHECK(never.clock.time == 6);
  CHECK_FALSE(never.stoppedBy);
  const World late = ranUntil(scene, {.event = StopEvent::born, .of = {cell("BA")}, .after = 4.5});
  CHECK(late.clock.time == 5);
}

TEST_CASE("A scene whose start fulfils a condition has nothing to run") {
  const Scene scene = scenes::lineageOnly(scenes::uniqueFour, 6);
  CHECK(ranUntil(scene, {.event = StopEvent::born, .of = {cell("")}}).clock.step == 0);
}

TEST_CASE("Conditions alone fail after 1000 cycles if none comes to hold") {
  Scene scene = scenes::lineageOnly("START: a0\nk(a0|a0)\n", 1);
  scene.stop = {};
  const auto failure = failureOf([&] { ranUntil(scene, {.event = StopEvent::cells, .count = 2}); });
  REQUIRE(failure);
  CHECK_THAT(failure->what(), Catch::Contains("stop.when: no condition has held in 1000 cycles"));
}

TEST_CASE("Bodies: the run goes as without the condition, and ends at the first look at which it holds") {
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 3);
  scene.mechanics->contact.emplace();
  const auto areaAt = [](const World& world) {
    double most = 0;
    const Observation now(world);
    for (const ContactArea& contact : now.contacts()) most = std::max(most, contact.area);
    return most;
  };
  const double every = 0.125;
  // Brute force: every look of a run without the condition, seen one by one.
  const StopWhen touch{.event = StopEvent::touch, .of = {cell("A"), cell("B")}};
  const World stopped = ranUntil(scene, touch, every);
  REQUIRE(stopped.stoppedBy);
  World plain = makeWorld(scene);
  double first = NAN;
  while (!finished(plain) && std::isnan(first)) {
    const double before = plain.clock.time;
    const double next = plain.clock.nextCycle;
    step(plain);
    const bool looks =
        std::floor(before / every) != std::floor(plain.clock.time / every) || plain.clock.nextCycle != next;
    if (looks && areaAt(plain) > 0) first = plain.clock.time;
  }
  CHECK(stopped.clock.time == first);
  CHECK(stateHash(stopped) == stateHash(plain));
}

TEST_CASE("Without bodies, conditions that need them do not hold, and nothing is measured") {
  for (const char* measure : {"cell.volume", "sphericity", "sister_contact", "lumen", "outermost", "pair.area"}) {
    CAPTURE(measure);
    const Scene scene = scenes::lineageOnly(scenes::uniqueFour, 3);
    CHECK_FALSE(ranUntil(scene, {.event = StopEvent::measure, .measure = measure, .above = -1e9}).stoppedBy);
  }
  const StopWhen touch{.event = StopEvent::touch, .of = {cell("A"), cell("B")}};
  CHECK_FALSE(ranUntil(scenes::lineageOnly(scenes::uniqueFour, 3), touch).stoppedBy);
  const StopWhen rest{.event = StopEvent::rest, .below = 1e9};
  CHECK_FALSE(ranUntil(scenes::lineageOnly(scenes::uniqueFour, 3), rest).stoppedBy);
}

TEST_CASE("A look follows a death and a cycle without a birth") {
  const Scene scene = scenes::lineageOnly("START: a0\ng1(a1|a0)\ng2(die|a1)\n", 5);
  CHECK(ranUntil(scene, {.event = StopEvent::cells, .of = {substance("a1")}, .count = 1}, 100).clock.time == 1);
  Scene bodies = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(a1|a1)\n", 5);
  const World world = ranUntil(bodies, {.event = StopEvent::cells, .of = {substance("a1")}, .count = 1}, 100);
  CHECK(world.stoppedBy);
  CHECK(world.clock.time < 1.1);  // not at the planned end, 5, though no look is due before 100
}

TEST_CASE("Cells rest at the first look at which every one is slow enough") {
  Scene scene = scenes::withBodies("START: a0\ng1(a1|a0)\ng2(divide|a0)\n", 8);
  scene.mechanics->contact.emplace();
  scene.mechanics->physics.drag = 3;
  const double bound = 0.05, every = 0.125;
  World plain = makeWorld(scene);
  const auto isSlow = [&] {  // by vertices, one by one
    bool slow = true;
    const Bodies& bodies = *plain.bodies;
    for (int i = 0; i < bodies.count; ++i) {
      const int slot = bodies.slots[i];
      double sum = 0;
      for (int v = 0; v < bodies.vertexCount(slot); ++v) {
        const Vector u = bodies.read(bodies.velocity, slot, v);
        sum += u.x * u.x + u.y * u.y + u.z * u.z;
      }
      slow = slow && std::sqrt(sum / bodies.vertexCount(slot)) < bound;
    }
    return slow;
  };
  const StopWhen rest{.event = StopEvent::rest, .below = bound, .after = 1.5};
  const World stopped = ranUntil(scene, rest, every);
  REQUIRE(stopped.stoppedBy);
  double first = NAN;
  while (!finished(plain) && std::isnan(first)) {
    const double before = plain.clock.time;
    step(plain);
    const bool looks = std::floor(before / every) != std::floor(plain.clock.time / every);
    if (looks && plain.clock.time >= rest.after && isSlow()) first = plain.clock.time;
  }
  CHECK(stopped.clock.time == first);
  CHECK(ranUntil(scene, {.event = StopEvent::rest, .below = 1e9}, every).clock.step > 0);  // not at the start
}

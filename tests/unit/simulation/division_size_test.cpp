// Cells that grow and divide at a size [Amir 2014]: timer, sizer and adder, on cells without contact.
#include <algorithm>
#include <map>

#include "catch.h"
#include "physics/growth.h"
#include "worlds.h"

using namespace morula;

namespace {

/// Returns a scene of three balls of unequal size that grow from the start and are due for division every 1/16.
Scene growing(std::optional<DivisionSize> size, double rate = 0.125) {
  Scene s = scenes::withBodies("START: a, grow\ng1(a|a)\ng2(grow|a)\ng3(divide|a)\n", 9, makeIcosphere(1));
  PhysicsParameters& p = s.mechanics->physics;
  p.cell = {1, 1, CellModel::sphere};
  p.timeStep = 0x1p-7;
  p.growth = GrowthParameters{rate};
  s.cycle.length = 0x1p-4;
  s.cycle.divisionSize = size;
  s.stop = {.cycles = {}, .time = 16, .cells = {}};
  s.cells = {{.at = {-4, 0, 0}, .scale = 0.75}, {.at = {0, 0, 0}, .scale = 0.85}, {.at = {4, 0, 0}, .scale = 0.95}};
  return s;
}

struct Life {
  double born, divided, birthSize, size;  // [time], [time] and sizes at rest [1]
};

/// Returns the life of each cell that divided, by path. Sizes are read after every step.
std::map<CellPath, Life> livesOf(const Scene& scene) {
  World world = makeWorld(scene);
  std::map<CellPath, double> atBirth, last;
  std::map<CellPath, Life> lives;
  const auto watch = [&] {
    for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
      const double size = sizeAtRest(*world.bodies, world.bodies->slots[i]);
      atBirth.try_emplace(world.cells.path[i], size);
      last[world.cells.path[i]] = size;
    }
  };
  watch();
  while (!finished(world)) step(world), watch();
  for (const LineageEntry& e : world.lineage.entries)
    if (e.fate == Fate::divided && atBirth.contains(e.path))
      lives[e.path] = {e.born, e.ended, atBirth[e.path], last[e.path]};
  return lives;
}

constexpr double oneStep = 0.125 * 0x1p-7 * 1.5;  // [1] the largest growth in a step, and half of it more

}  // namespace

TEST_CASE("Sizer: cells divide at one size, whatever they were born with") {
  const auto lives = livesOf(growing(DivisionSize{DivisionSize::Rule::sizer, 1}));
  CHECK(lives.size() > 12);
  std::vector<double> births;
  for (const auto& [path, life] : lives) {
    CAPTURE(path.text());
    CHECK(life.size == Approx(1).margin(oneStep));
    births.push_back(life.birthSize);
    // Growth is exponential: a cell divides after ln(1/birth size) over the rate.
    CHECK(life.divided - life.born == Approx(std::log(1 / life.birthSize) / 0.125).margin(0.05));
  }
  CHECK(*std::ranges::max_element(births) > 1.5 * *std::ranges::min_element(births));
}

TEST_CASE("Adder: cells divide when they have gained the same, and sizes at birth come to it") {
  const auto lives = livesOf(growing(DivisionSize{DivisionSize::Rule::adder, 0.5}));
  CHECK(lives.size() > 12);
  for (const auto& [path, life] : lives) {
    CAPTURE(path.text());
    CHECK(life.size - life.birthSize == Approx(0.5).margin(oneStep));
    // Both daughters get half, so a deviation from 0.5 halves with each generation.
    if (lives.contains(path.daughter(false)))
      CHECK(lives.at(path.daughter(false)).birthSize - 0.5 == Approx((life.birthSize - 0.5) / 2).margin(oneStep));
  }
}

TEST_CASE("Timer: cells divide at one age, whatever their size") {
  Scene scene = growing({});
  scene.cycle.length = 2;
  scene.stop.time = 8;
  const auto lives = livesOf(scene);
  CHECK(lives.size() > 12);
  for (const auto& [path, life] : lives) CHECK(life.divided - life.born == Approx(2).margin(0x1p-6));
}

TEST_CASE("So it is with membranes, and unequal cuts are grown up for") {
  Scene scene = scenes::withBodies("START: a, grow\ng1(a|a)\ng2(grow|a)\ng3(divide|a)\n", 9);
  scene.mechanics->physics.growth = GrowthParameters{0.25};
  scene.mechanics->physics.drag = 4;
  scene.cycle.length = 0.125;
  scene.cycle.divisionSize = DivisionSize{DivisionSize::Rule::sizer, 1.25};
  scene.stop = {.cycles = {}, .time = 6, .cells = {}};
  const auto lives = livesOf(scene);
  REQUIRE(lives.size() >= 3);
  for (const auto& [path, life] : lives) CHECK(life.size == Approx(1.25).margin(0.01));
  CHECK(lives.begin()->second.divided == Approx(std::log(1.25) / 0.25).margin(0.05));
}

TEST_CASE("A cell that has waited begins its next cycle when it divides") {
  Scene scene = growing(DivisionSize{DivisionSize::Rule::sizer, 1});
  scene.cycle.length = 1;
  World world = makeWorld(scene);
  while (world.lineage.entries.size() < 6) step(world);
  bool seen = false;
  for (std::size_t i = 0; i < world.cells.path.size(); ++i) {
    if (world.cells.path[i].depth() < 2) continue;
    seen = seen || world.lineage.entries[world.cells.entry[i]].born == world.cells.lastCycle[i];
  }
  CHECK(seen);
}

TEST_CASE("Where no cell can come to its size the run ends when it should, one step after the other") {
  Scene scene = growing(DivisionSize{DivisionSize::Rule::sizer, 2});
  scene.mechanics->physics.growth->until = 1.5;
  scene.stop.time = 20;
  const World world = ranToEnd(scene);
  CHECK(world.cells.path.size() == 3);
  CHECK(world.clock.time == Approx(20));
  for (int slot : world.bodies->slots) {
    CHECK(sizeAtRest(*world.bodies, slot) == Approx(1.5).epsilon(1e-9));
    CHECK(sizeAtRest(*world.bodies, slot) <= 1.5 * (1 + 1e-6));
  }
}

TEST_CASE(
    "Growth stops at its size, of balls, membranes and matched shapes; what is larger stays, what shrinks shrinks") {
  for (CellModel model : {CellModel::sphere, CellModel::shell, CellModel::shapeMatching})
    for (const char* gene : {"grow", "shrink"}) {
      Scene scene = scenes::withBodies(std::string("START: a\ng1(a|a)\ng2(") + gene + "|a)\n", 9);
      scene.mechanics->physics.cell = {1, 1, model};
      scene.mechanics->physics.drag = 2;
      scene.mechanics->physics.growth = GrowthParameters{0.25, 1.25};
      scene.cells = {{.at = {-4, 0, 0}}, {.at = {4, 0, 0}, .scale = 1.25}};
      scene.stop = {.cycles = {}, .time = 4, .cells = {}};
      if (model == CellModel::sphere) scene.mechanics->physics.timeStep = 0x1p-6;
      const World world = ranToEnd(scene);
      CAPTURE(nameOf(model), gene);
      const bool grows = gene == std::string("grow");
      const double shrunk = std::exp(-0.25 * 3), large = 1.25 * 1.25 * 1.25;
      CHECK(sizeAtRest(*world.bodies, world.bodies->slots[0]) == Approx(grows ? 1.25 : shrunk).epsilon(0.01));
      CHECK(sizeAtRest(*world.bodies, world.bodies->slots[1]) == Approx(grows ? large : large * shrunk).epsilon(0.01));
    }
}

TEST_CASE("An early or a late cell's waiting does not move the others' cycles") {
  // The third cell divides at once; the others wait while their rounds pass.
  Scene scene = growing(DivisionSize{DivisionSize::Rule::sizer, 0.8}, 0.001);
  scene.stop.time = 1;
  const World world = ranToEnd(scene);
  int divided = 0;
  for (const LineageEntry& e : world.lineage.entries)
    if (e.fate == Fate::divided && e.born < e.ended) {
      ++divided;
      CHECK(e.ended == 0x1p-4);
    }
  CHECK(divided == 1);
  for (std::size_t i = 0; i < world.cells.path.size(); ++i)
    CHECK(world.cells.lastCycle[i] == (world.cells.path[i].letter(0) ? 0x1p-4 : 0));  // B was the third cell
}

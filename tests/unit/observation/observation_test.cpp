// A cell's properties and contacts at one instant, against all pairs of the world; nothing is measured unasked.
#include "observation/observation.h"

#include <numbers>

#include "catch.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

World packedWorld() { return ranTo(scenes::packed(), 3.5); }

/// Biology in which every cell copies its sister's state at each cycle. `seen` records both states when a cell is asked
/// whether it divides.
struct Copycat final : IdleUnit {
  StateId runCellCycle(const CellContext& cell) override { return cell.sister() ? cell.sister()->state : 0; }
  bool wantsToDivide(const CellContext& cell) const override {
    if (cell.sister()) seen.push_back({cell.state, cell.sister()->state});
    return cell.path.isEgg();
  }
  StateId daughterState(StateId, bool b) override { return b ? 2 : 1; }
  mutable std::vector<std::pair<StateId, StateId>> seen;
};

}  // namespace

TEST_CASE("A cell knows its path, state, ages, substances, sister, and how its mother was cut") {
  const World world = packedWorld();
  const Observation now(world, 3.25);
  for (int i = 0; i < 8; ++i) {
    const ObservedCell cell(now, i);
    const CellPath& path = world.cells.path[i];
    CHECK(cell.path == path);
    CHECK(cell.state == world.cells.state[i]);
    CHECK(cell.substances() == world.biology->describe(cell.state));
    CHECK(cell.time == 3.25);
    const auto order = orderByPath(world.lineage);
    CHECK(cell.born == find(world.lineage, order, path)->born);
    CHECK(cell.age() == 3.25 - cell.born);
    CHECK(ObservedCell(Observation(world, cell.born / 2), i).age() == 0);
    CHECK(cell.lastCycle == world.cells.lastCycle[i]);
    REQUIRE(cell.sister());
    CHECK(cell.sister()->path == path.mother().daughter(!path.letter(2)));
    REQUIRE(cell.motherDivision());
    CHECK(cell.motherDivision()->path == path.mother());
    CHECK(cell.motherDivision()->time == cell.born);
  }
}

TEST_CASE("An egg has neither sister nor mother's division; a founder no division; the dead are nobody's sister") {
  const World egg = makeWorld(scenes::withBodies(scenes::uniqueFour, 1));
  CHECK_FALSE(ObservedCell(Observation(egg), 0).sister());
  CHECK_FALSE(ObservedCell(Observation(egg), 0).motherDivision());
  const Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  const World two = worldOf(scene, flyingCells(scene.mechanics->mesh, 2, 3, 0));
  const Observation now(two);
  CHECK(ObservedCell(now, 0).sister()->path.text() == "B");
  CHECK_FALSE(ObservedCell(now, 0).motherDivision());
  World dying = makeWorld(scenes::lineageOnly("START: a0\ng1(divide|a0)\ng2(die|A)\n", 3));
  step(dying);
  step(dying);
  REQUIRE(pathsOf(dying) == std::vector<std::string>{"B"});
  CHECK_FALSE(ObservedCell(Observation(dying), 0).sister());
}

TEST_CASE("Neighbours are those of the contacts' list, by path, each from both sides with one area") {
  const World world = packedWorld();
  const Observation now(world);
  const auto pairs = measureContactAreas(*world.contacts, *world.bodies);
  std::size_t seen = 0;
  for (int i = 0; i < 8; ++i) {
    const ObservedCell cell(now, i);
    std::vector<std::pair<CellPath, double>> expected;  // all pairs, in any order
    for (int j = 0; j < 8; ++j)
      for (const ContactArea& p : pairs)
        if ((p.a == i && p.b == j) || (p.a == j && p.b == i)) expected.push_back({world.cells.path[j], p.area});
    REQUIRE(cell.neighbours().size() == expected.size());
    CHECK(expected.size() >= 3);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const Neighbour& n = cell.neighbours()[k];
      CHECK(n.cell->path == expected[k].first);
      CHECK(n.area == expected[k].second);
      CHECK(n.cell->state == world.cells.state[cellNumber(world.cells, n.cell->path)]);
      CHECK(n.cell->neighbours().size() >= 3);
      ++seen;
    }
  }
  CHECK(seen == 2 * pairs.size());
}

TEST_CASE("Balls touch over the disc in which they meet, each pair of them that does") {
  Scene scene = scenes::spheres();
  scene.stop = {.cycles = {}, .time = {}, .cells = 16};
  const World world = ranToEnd(scene);
  const Bodies& b = *world.bodies;
  const Observation now(world);
  int touching = 0;
  for (int i = 0; i < b.count; ++i) {
    std::vector<std::pair<int, double>> expected;
    for (int j = 0; j < b.count; ++j) {
      const double r = b.parameters.cell.radius * b.restScale[b.slots[i]],
                   s = b.parameters.cell.radius * b.restScale[b.slots[j]];
      const double d = norm(b.vertex(b.slots[i], 0) - b.vertex(b.slots[j], 0));
      if (i == j || d >= r + s) continue;
      // Heron: the disc's radius is twice the area of the triangle with sides r, s, d over d.
      const double p = (r + s + d) / 2, heron = p * (p - r) * (p - s) * (p - d);
      if (heron > 0) expected.push_back({j, 4 * std::numbers::pi * heron / (d * d)});
    }
    const ObservedCell cell(now, i);
    REQUIRE(cell.neighbours().size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      CHECK(cell.neighbours()[k].cell->path == world.cells.path[expected[k].first]);
      CHECK(cell.neighbours()[k].area == Approx(expected[k].second).epsilon(1e-9).margin(1e-12));
      ++touching;
    }
  }
  CHECK(touching > 16);
}

TEST_CASE("A body is measured as its mesh says") {
  const World world = packedWorld();
  const Observation now(world);
  for (int i = 0; i < 8; ++i) {
    const ObservedCell cell(now, i);
    const Mesh mesh = cellMesh(world, cell.path);
    const BodyShape& shape = cell.physical()->getShape();
    CHECK(shape.surface.vertices == mesh.vertices);
    CHECK(shape.surface.faces == mesh.faces);
    CHECK(shape.volume == measureVolume(mesh.vertices, mesh.faces));
    CHECK(shape.area == measureArea(mesh.vertices, mesh.faces));
    CHECK(shape.centre == measureCentroid(mesh.vertices));
    CHECK(cell.physical()->getVolume() == world.bodies->volume[cell.slot()]);
    CHECK(cell.physical()->getMass() == world.bodies->mass(cell.slot()));
    CHECK(cell.physical()->getPressure() == world.bodies->pressure[cell.slot()]);
  }
}

TEST_CASE("What nobody asks for is not measured, and what is asked for is measured once") {
  using Counts = Observation::Counts;
  const World world = packedWorld();
  const Observation now(world);
  const ObservedCell cell(now, 3);
  cell.sister();
  cell.motherDivision();
  cell.substances();
  cell.physical()->getVolume();
  cell.physical()->getRestVolume();
  CHECK(now.measured() == Counts{});
  for (int turn = 0; turn < 2; ++turn)
    for (int i = 0; i < 8; ++i) now.cell(i).neighbours();
  cell.neighbours();
  CHECK(now.measured() == Counts{.shapes = 0, .contacts = 1});
  cell.physical()->getShape();
  cell.physical()->getShape();
  now.cell(5).physical()->getShape();
  now.cell(5).physical()->getShape();
  CHECK(now.measured() == Counts{.shapes = 2, .contacts = 1});
}

TEST_CASE("Without bodies nothing is there to measure; without contact nobody touches") {
  const World lineage = ranToEnd(scenes::lineageOnly(scenes::uniqueFour, 3));
  const Observation now(lineage);
  const ObservedCell cell(now, 0);
  CHECK_FALSE(cell.physical());
  CHECK(cell.neighbours().empty());
  CHECK_FALSE(cell.motherDivision());
  CHECK(cell.sister()->path.text() == "AB");
  const Scene scene = scenes::withBodies(scenes::uniqueFour, 1);
  const World apart = worldOf(scene, flyingCells(scene.mechanics->mesh, 2, 1, 0));
  const Observation crossing(apart);
  CHECK(ObservedCell(crossing, 0).neighbours().empty());
  CHECK(crossing.measured().contacts == 0);
}

TEST_CASE("All cells decide on the same instant: two that copy each other exchange their states") {
  auto biology = std::make_unique<Copycat>();
  const Copycat& cats = *biology;
  World world = makeWorld(scenes::lineageOnly(scenes::uniqueFour, 9), std::move(biology), {});
  step(world);
  REQUIRE(world.cells.state == std::vector<StateId>{1, 2});
  cats.seen.clear();
  step(world);
  CHECK(world.cells.state == std::vector<StateId>{2, 1});
  // Cells are asked for their wishes at the instant after all cycles.
  CHECK(cats.seen == std::vector<std::pair<StateId, StateId>>{{2, 1}, {1, 2}});
  step(world);
  CHECK(world.cells.state == std::vector<StateId>{1, 2});
  for (const LineageEntry& e : world.lineage.entries)
    if (!e.path.isEgg()) CHECK(e.state == (e.path.letter(0) ? 2u : 1u));
}

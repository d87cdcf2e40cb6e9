// Perceptions of cells against scenes laid out by hand. Turning, renaming or other execution changes nothing.
#include <algorithm>
#include <set>

#include "catch.h"
#include "observation/body_measures.h"
#include "worlds.h"

using namespace morula;

namespace {

SenseParameters sense(const char* substance, SenseKind kind, Threshold is, const char* of = "",
                      std::optional<double> number = {}) {
  SenseParameters s{substance, kind};
  s.is = is;
  s.of = of;
  s.number = number;
  return s;
}

/// Returns the substances that each cell holds after its first cycle, under the given senses.
std::vector<std::string> statesAfterOneCycle(Scene scene, const std::vector<SenseParameters>& senses,
                                             const Execution& execution = {}) {
  scene.senses = senses;
  const World world = ranTo(scene, scene.cycle.length, execution);
  return statesOf(world);
}

Scene balls(std::vector<StartCell> cells, const std::string& dna, std::set<std::string> sensed) {
  Scene s = scenes::withBodies(scenes::everybodyDivides, 9, makeIcosphere(1));
  s.dna = scenes::dnaThatSenses(dna, std::move(sensed));
  s.mechanics->physics.cell = {1, 1, CellModel::sphere};
  s.mechanics->physics.timeStep = 0x1p-4;
  s.mechanics->physics.drag = 4;
  s.cycle.length = 0x1p-4;
  s.cells = std::move(cells);
  return s;
}

using Names = std::vector<std::string>;

/// Rotates by exchanging coordinates and signs, so that no number is rounded.
Vector turned(const Vector& v) { return {v.y, -v.z, -v.x}; }

}  // namespace

TEST_CASE("Balls perceive who touches them, who has most of their contact and who is near") {
  // A row of source, target and other, with two more cells far away.
  const std::string dna = "START: s, t\ng1(t|t)\ng2(s|s)\ng3(x|touched, many, most, near, any)\n";
  const auto states = statesAfterOneCycle(
      [&] {
        Scene s = balls({{.at = {-1.9, 0, 0}, .substances = Names{"s"}},
                         {.at = {0, 0, 0}, .substances = Names{"t"}},
                         {.at = {1.99, 0, 0}, .substances = Names{"t"}},
                         {.at = {9, 0, 0}, .substances = Names{"t"}},
                         {.at = {12, 0, 0}, .substances = Names{"s"}}},
                        dna, {"touched", "many", "most", "near", "any"});
        s.mechanics->contact = scenes::pairContact;
        return s;
      }(),
      {sense("any", SenseKind::neighbours, {.atLeast = 1}), sense("many", SenseKind::neighbours, {.atLeast = 2}),
       sense("most", SenseKind::majority, {}, "s"), sense("near", SenseKind::near, {}, "s", 3.5),
       sense("touched", SenseKind::contact, {}, "s")});
  CHECK(states == Names{"any s", "any many most near t touched x", "any t", "near t", "s"});
}

TEST_CASE("A ball perceives what others release, by e^(-r/range)/r") {
  // Values: 0.18394 at distance 2, 0.033834 at 4, 0.21777 with both.
  const auto statesAbove = [](double bound) {
    return statesAfterOneCycle(balls({{.at = {0, 0, 0}, .substances = Names{"s"}},
                                      {.at = {0, 2, 0}, .substances = Names{"s"}},
                                      {.at = {0, 0, 4}, .substances = Names{"t"}},
                                      {.at = {0, 4, 0}, .substances = Names{"t"}}},
                                     "START: s, t\ng1(t|t)\ng2(s|s)\ng3(x|much)\n", {"much"}),
                               {sense("much", SenseKind::diffusion, {.atLeast = bound}, "s", 2)});
  };
  CHECK(statesAbove(0.2177) == Names{"s", "s", "t", "much t x"});
  CHECK(statesAbove(0.2178) == Names{"s", "s", "t", "t"});
  CHECK(statesAbove(0.1839) == Names{"much s x", "much s x", "t", "much t x"});
  CHECK(statesAbove(0.1840) == Names{"s", "s", "t", "much t x"});
}

TEST_CASE("Two cells that perceive each other do so of one instant") {
  Scene scene = balls({{.at = {-0.9, 0, 0}, .substances = Names{"p"}}, {.at = {0.9, 0, 0}, .substances = Names{"q"}}},
                      "START: p, q\ng1(q|p, byQ)\ng2(p|q, byP)\n", {"byP", "byQ"});
  scene.mechanics->contact = scenes::pairContact;
  const std::vector<SenseParameters> both{sense("byP", SenseKind::contact, {}, "p"),
                                          sense("byQ", SenseKind::contact, {}, "q")};
  CHECK(statesAfterOneCycle(scene, both) == Names{"byQ q", "byP p"});
}

TEST_CASE("A cell on the shell perceives the share of its surface that lies there") {
  Scene scene = scenes::withBodies("START: a\ng1(a|a)\n", 2, scenes::scaled(makeIcosphere(2), 0.95));
  scene.mechanics->physics.shell = ShellParameters{{0.93, 0.93, 0.93}};
  const World world = ranTo(scene, 0.5);
  // The egg more than fills the shell, which presses on its whole surface, 0.012 below its vertices.
  CHECK(ObservedCell(Observation(world), 0).shellShare() == Approx(1));
  // Each vertex of an octahedron stands for a sixth of the area of its eight faces.
  BodyShape octahedron{};
  octahedron.surface.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int z : {4, 5})
    for (const auto& [x, y] : {std::pair{0, 2}, std::pair{2, 1}, std::pair{1, 3}, std::pair{3, 0}})
      octahedron.surface.faces.push_back({x, y, z});
  octahedron.sag = 0.25;  // l²/8
  const double out = 0.75;
  CHECK(measureShellShare(octahedron, {{out, out, out}}) == Approx(1));
  CHECK(measureShellShare(octahedron, {{2, 2, 2}}) == 0);
  CHECK(measureShellShare(octahedron, {{1, 1, 1}}) == 0);
  CHECK(measureShellShare(octahedron, {{0.75, 4, 4}}) == Approx(2 / 6.0));
  CHECK(measureShellShare(octahedron, {{0.75, 0.75, 4}}) == Approx(4 / 6.0));
  ShellParameters planes;
  planes.mesh = std::make_shared<ConvexShell>(ConvexShell{{}, {{{1, 0, 0}, 1}, {{0, 0, -1}, 1}, {{0, 1, 0}, 2}}});
  CHECK(measureShellShare(octahedron, planes) == Approx(2 / 6.0));
  octahedron.isBall = true;
  CHECK(measureShellShare(octahedron, {{out, out, out}}) == 0);
}

TEST_CASE("A connection and a sister are perceived while they are there") {
  // A dies at time 2; B lives on.
  Scene scene = scenes::withBodies(scenes::everybodyDivides, 9);
  scene.dna = scenes::dnaThatSenses(
      "START: a\ng1(b|a)\ng2(divide|a)\ng3(die|b, A, held)\ng4(c|b)\ng5(c|c)\ng6(alone|c, gone)\ng7(x|hasC, hasB)\n",
      {"held", "gone", "hasB", "hasC"});
  scene.mechanics->connections =
      ConnectionParameters{MakeConnections::atDivision, ConnectionsOnDivision::both, 0.1, {}};
  SenseParameters gone = sense("gone", SenseKind::sister, {});
  gone.lives = false;
  scene.senses = {gone, sense("hasB", SenseKind::sister, {}, "b"), sense("hasC", SenseKind::sister, {}, "c"),
                  sense("held", SenseKind::connected, {})};
  World world = makeWorld(scene);
  const auto statesAt = [&](double time) {
    runTo(world, time);
    return statesOf(world);
  };
  CHECK(statesAt(1) == Names{"A b divide", "B b divide"});
  CHECK(statesAt(2) == Names{"c hasB held"});
  CHECK(statesAt(3) == Names{"alone c gone"});
}

TEST_CASE("Turning a scene turns its result: cells perceive the same") {
  Scene scene = scenes::packed();
  scene.mechanics->physics.shell.reset();
  scene.dna = scenes::dnaThatSenses("START: a0\ng1(a0|a0)\ng2(x|a, b, c, d, e, f)\n", {"a", "b", "c", "d", "e", "f"});
  scene.stop.time = 2;
  SenseParameters along = sense("d", SenseKind::position, {.above = 0.2});
  along.axis = {0.3, -1, 0.2};
  const std::vector<SenseParameters> senses{
      sense("a", SenseKind::neighbours, {.atLeast = 3}),  sense("b", SenseKind::volume, {.below = 1.0}),
      sense("c", SenseKind::majority, {}, "a"),           along,
      sense("e", SenseKind::elongation, {.above = 1.05}), sense("f", SenseKind::diffusion, {.above = 2.5}, "a0", 1.5)};
  std::vector<Body> cells = flyingCells(scene.mechanics->mesh, 8, 1.7, 0.5);
  const auto run = [&](bool turn, const Execution& execution) {
    Scene s = scene;
    s.senses = senses;
    std::vector<Body> bodies = cells;
    if (turn) {
      s.senses[3].axis = turned(along.axis);
      for (Body& body : bodies) {
        for (Point& x : body.position) x = turned(x);
        for (Vector& u : body.velocity) u = turned(u);
      }
    }
    World world = worldOf(s, bodies, execution);
    world.clock.nextCycle = 1;
    runToEnd(world);
    return statesOf(world);
  };
  const Names plain = run(false, {Isa::scalar, 1});
  CHECK(std::set<std::string>(plain.begin(), plain.end()).size() > 3);  // cells perceive different things
  CHECK(run(true, {Isa::scalar, 1}) == plain);
  CHECK(run(false, {bestIsa(), 3}) == plain);
}

TEST_CASE("The order of senses does not matter") {
  Scene scene = scenes::sensing();
  const World one = ranToEnd(scene);
  CHECK(one.cells.path.size() > 3);
  std::reverse(scene.senses.begin(), scene.senses.end());
  CHECK(hashState(ranToEnd(scene, {bestIsa(), 2})).whole == hashState(one).whole);
}

TEST_CASE("A scene that senses nothing measures nothing") {
  Scene scene = scenes::packed();
  const World world = ranTo(scene, 2.5);
  const Observation now(world);
  for (int i = 0; i < 4; ++i) world.biology->runCellCycle(ObservedCell(now, i));
  CHECK(now.measured() == Observation::Counts{});
}

// Connections in a living world: how they are made, inherited and released.
#include "simulation/connect.h"

#include "catch.h"
#include "connecting.h"
#include "simulation/move_physics.h"
#include "simulation/population.h"

using namespace morula;

namespace {

/// Returns a world in a shell, which keeps neighbours in touch.
World inShell(Scene scene) {
  scene.mechanics->physics.shell = ShellParameters{{1, 1, 1}};
  return makeWorld(scene);
}

const std::set<std::string> none;

/// Biology of cells that all have the same wish.
struct Wish final : IdleUnit {
  double wantsToConnect(const CellContext&) const override { return wish; }
  double wish = 1;
};

}  // namespace

TEST_CASE("At division sisters are connected, from their birth on") {
  World world = makeWorld(connecting(scenes::uniqueFour, MakeConnections::atDivision, ConnectionsOnDivision::plane));
  CHECK(pairsOf(world) == none);
  runTo(world, 1.01);
  CHECK(pairsOf(world) == std::set<std::string>{"A-B"});
  CHECK(world.connections->history[0].made == world.lineage.entries[1].born);
}

TEST_CASE("The plane decides: a connection goes to the daughter on the other cell's side") {
  const World world =
      ranTo(connecting(scenes::uniqueFour, MakeConnections::atDivision, ConnectionsOnDivision::plane), 2.02);
  // Along x the cells are AA AB | BA BB: A lies on the +x side, and AA within A.
  REQUIRE(pathsOf(world) == std::vector<std::string>{"AA", "AB", "BA", "BB"});
  CHECK(pairsOf(world) == std::set<std::string>{"AA-AB", "AB-BA", "BA-BB"});
  CHECK(world.connections->history[0].cause == ReleaseCause::divided);
  CHECK(world.connections->history[0].released == world.lineage.entries[1].ended);
}

namespace {

/// Cuts off a small cap, which becomes daughter A or B.
struct CapOff final : DivisionPolicy {
  explicit CapOff(bool toB) : normal{toB ? -1.0 : 1.0, 0, 0} {}
  Cut findCut(const CellContext&) const override { return {{0.6, 0, 0}, normal}; }
  Vector normal;
};

}  // namespace

TEST_CASE("The plane decides, or who is nearer: a small daughter beyond it may be nearer than her large sister") {
  for (const auto policy : {ConnectionsOnDivision::plane, ConnectionsOnDivision::nearest})
    for (const bool bigOneIsA : {false, true}) {
      Scene scene = connecting(scenes::everybodyDivides, MakeConnections::atDivision, policy);
      scene.mechanics->mesh = makeIcosphere(3);
      World world = ballsAt(scene, {{}, {0.5, 2.1, 0}});  // on the large side, beside the cap
      world.divisionPolicy = std::make_unique<CapOff>(bigOneIsA);
      connect(*world.connections, CellPath::parse("A"), CellPath::parse("B"), 0);
      changePopulation(world, Observation(world), {CellChange::divides, CellChange::none});
      REQUIRE(pathsOf(world) == std::vector<std::string>{"AA", "AB", "B"});
      const std::string big = bigOneIsA ? "AA" : "AB", small = bigOneIsA ? "AB" : "AA";
      CHECK(norm(centreOf(world, small.c_str()) - centreOf(world, "B")) <
            norm(centreOf(world, big.c_str()) - centreOf(world, "B")));
      const bool nearest = policy == ConnectionsOnDivision::nearest;
      CHECK(pairsOf(world) == std::set<std::string>{"AA-AB", (nearest ? small : big) + "-B"});
    }
}

TEST_CASE("Both keep: each daughter has every connection of her mother") {
  World world = ranTo(connecting(scenes::uniqueFour, MakeConnections::atDivision, ConnectionsOnDivision::both), 2.02);
  CHECK(pairsOf(world) == std::set<std::string>{"AA-AB", "AA-BA", "AA-BB", "AB-BA", "AB-BB", "BA-BB"});
}

TEST_CASE("What both keep is released where the cells are too far apart, and the cause is on record") {
  ConnectionParameters p = withPolicy(MakeConnections::atDivision, ConnectionsOnDivision::both);
  p.releaseDistance = 1.3;  // in sums of radii: direct neighbours are at about 1, the next at 2
  const World world = ranTo(connecting(scenes::uniqueFour, p), 2.8);
  const auto left = pairsOf(world);
  CHECK(left.count("AA-AB") == 1);
  CHECK(left.count("BA-BB") == 1);
  CHECK(left.count("AA-BB") == 0);
  int byDistance = 0;
  for (const ConnectionRecord& r : world.connections->history) byDistance += r.cause == ReleaseCause::distance;
  CHECK(byDistance >= 1);
}

TEST_CASE("By gene: neighbours that want to connect do, at their cell cycle, and no others") {
  const std::string dna = "START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1)\ng4(a2|a2)\ng5(connect|a1)\n";
  World world = inShell(connecting(dna, MakeConnections::byGene, ConnectionsOnDivision::plane));
  runTo(world, 1.9);
  CHECK(pairsOf(world) == none);  // no connection from the division
  runTo(world, 2.02);
  REQUIRE(pairsOf(world) == std::set<std::string>{"A-B"});
  CHECK(world.connections->history[0].made == Approx(2).margin(0.02));

  Scene apart = connecting(dna, MakeConnections::byGene, ConnectionsOnDivision::plane);
  apart.mechanics->contact.reset();
  World strangers = inShell(apart);
  runTo(strangers, 2.02);
  CHECK(pairsOf(strangers) == none);  // without contact no cell has neighbours
}

TEST_CASE("A connection pulls from the end of the step in which it is made or released") {
  const std::string dna = "START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1)\ng4(a3|a2)\ng5(connect|a1)\ng6(release|a2)\n";
  World world = inShell(connecting(dna, MakeConnections::byGene, ConnectionsOnDivision::plane));
  std::size_t before = 0;
  int changes = 0;
  while (world.clock.time < 3.1) {
    step(world);
    const std::size_t now = world.connections->active.size();
    if (now == before || world.clock.time < 1.5) continue;  // births evaluate the forces anyway
    before = now;
    ++changes;
    const auto accelerations = [&] {
      std::vector<Vector> ofCells;
      for (int slot : world.bodies->slots) {
        Vector sum;
        for (int v = 0; v < world.bodies->vertexCount(slot); ++v)
          sum += world.bodies->read(world.bodies->acceleration, slot, v);
        ofCells.push_back(sum / world.bodies->vertexCount(slot));
      }
      return ofCells;
    };
    const std::vector<Vector> asStepped = accelerations();
    evaluateForces(world);
    const std::vector<Vector> anew = accelerations();
    // The pull accelerates a cell of mass 0.5 by 0.1. The shell moves vertices by rounding when it holds them again.
    for (std::size_t cell = 0; cell < anew.size(); ++cell) CHECK(norm(anew[cell] - asStepped[cell]) < 1e-6);
  }
  CHECK(changes == 2);
}

TEST_CASE("By gene: the two cells' wishes are added") {
  const auto after = [](const std::string& ofA, const std::string& ofB) {
    const std::string dna =
        "START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1)\ng4(a2|a2)\ng5(" + ofA + "|A)\ng6(" + ofB + "|B)\n";
    World world = inShell(connecting(dna, MakeConnections::byGene, ConnectionsOnDivision::plane));
    runTo(world, 2.02);
    return pairsOf(world).size();
  };
  CHECK(after("connect", "connect") == 1);
  CHECK(after("connect", "a3") == 1);
  CHECK(after("connect", "release") == 0);
  CHECK(after("a3", "a4") == 0);
}

TEST_CASE("By gene: a cell acts at its own cell cycle only") {
  const Scene scene = connecting(scenes::uniqueFour, MakeConnections::byGene, ConnectionsOnDivision::plane);
  std::vector<Body> row;  // AA touches AB, AB touches BA
  for (int i = 0; i < 3; ++i) row.push_back(ballAt(scene.mechanics->mesh, {1.8 * i, 0, 0}, 200));
  using enum CellChange;
  World world = worldOf(scene, row, {Isa::scalar, 1}, std::make_unique<Wish>());
  REQUIRE(pathsOf(world) == std::vector<std::string>{"AA", "AB", "BA"});
  connectNeighbours(world, Observation(world), {none, none, none});
  CHECK(pairsOf(world) == std::set<std::string>{});
  connectNeighbours(world, Observation(world), {none, none, cycled});
  CHECK(pairsOf(world) == std::set<std::string>{"AB-BA"});
  connectNeighbours(world, Observation(world), {divides, none, none});
  CHECK(pairsOf(world) == std::set<std::string>{"AA-AB", "AB-BA"});

  static_cast<Wish&>(*world.biology).wish = -1;
  connectNeighbours(world, Observation(world), {none, none, none});
  CHECK(pairsOf(world).size() == 2);
  connectNeighbours(world, Observation(world), {cycled, none, none});
  CHECK(pairsOf(world) == std::set<std::string>{"AB-BA"});
  connectNeighbours(world, Observation(world), {none, none, dies});  // death releases it, not its wish
  CHECK(pairsOf(world) == std::set<std::string>{"AB-BA"});
}

TEST_CASE("By gene: a release ends what division made") {
  World world = inShell(connecting("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1)\ng4(a2|a2)\ng5(release|A)\n",
                                   MakeConnections::both, ConnectionsOnDivision::plane));
  runTo(world, 1.5);
  CHECK(pairsOf(world) == std::set<std::string>{"A-B"});
  runTo(world, 2.02);
  CHECK(pairsOf(world) == none);
  CHECK(world.connections->history[0].cause == ReleaseCause::gene);
}

TEST_CASE("A cell that dies is released from all") {
  const World world = ranTo(connecting("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(die|A)\ng4(a1|a1)\n",
                                       MakeConnections::atDivision, ConnectionsOnDivision::plane),
                            2.02);
  CHECK(pathsOf(world) == std::vector<std::string>{"B"});
  CHECK(pairsOf(world) == none);
  CHECK(world.connections->history[0].cause == ReleaseCause::died);
  CHECK(world.connections->history[0].released == Approx(2).margin(0.02));
}

TEST_CASE("A cell that divides while its partner dies takes nothing over") {
  const World world = ranTo(connecting("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(die|A)\ng4(divide|B)\ng5(a1|a1)\n",
                                       MakeConnections::atDivision, ConnectionsOnDivision::both),
                            2.02);
  CHECK(pathsOf(world) == std::vector<std::string>{"BA", "BB"});
  CHECK(pairsOf(world) == std::set<std::string>{"BA-BB"});
}

TEST_CASE("Connected cells stay closer than unconnected ones") {
  const auto distance = [](double strength) {
    ConnectionParameters p = withPolicy(MakeConnections::atDivision, ConnectionsOnDivision::plane);
    p.strength = strength;
    Scene scene = connecting("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a1|a1)\n", p);
    const World world = ranTo(scene, 6);
    return norm(centreOf(world, "A") - centreOf(world, "B"));
  };
  CHECK(distance(2) < 0.98 * distance(0.02));
}

// Further policies that make, inherit and release connections.
#include <set>

#include "catch.h"
#include "connecting.h"
#include "simulation/connect.h"
#include "simulation/population.h"
#include "simulation/time_step.h"

using namespace morula;

namespace {

/// Returns the number of partners of each cell.
std::multiset<int> countsOf(const World& world) {
  std::multiset<int> counts;
  for (const CellPath& path : world.cells.path)
    counts.insert(static_cast<int>(partners(*world.connections, path).size()));
  return counts;
}

}  // namespace

TEST_CASE("Daughter A takes all: four rounds make a cyst of sixteen cells with 4, 3, 2 and 1 bridges") {
  // Each cell keeps its bridges and makes a new one with each daughter: a binomial tree [Spradling 1993; de Cuevas &
  // Spradling 1998].
  World world = makeWorld(connecting(scenes::everybodyDivides, MakeConnections::atDivision, ConnectionsOnDivision::a));
  while (world.cells.path.size() < 16) step(world);
  CHECK(countsOf(world) == std::multiset<int>{1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 4, 4});
  CHECK(world.connections->active.size() == 15);
  CHECK(pairsOf(world).contains("AAAA-BAAA"));
}

TEST_CASE("Nearest: each connection goes to the daughter whose centre is nearer, whoever else divides") {
  using enum CellChange;
  const ConnectionParameters p = withPolicy(MakeConnections::byGene, ConnectionsOnDivision::nearest);
  // Three cells in a row, cut across x, A on its +x side: AA at 0, AB at 1.95, BA at 4.
  const auto after = [&](const std::vector<CellChange>& changes) {
    World world = ballsAt(connecting(scenes::everybodyDivides, p), {{0, 0, 0}, {1.95, 0, 0}, {4, 0, 0}});
    REQUIRE(pathsOf(world) == std::vector<std::string>{"AA", "AB", "BA"});
    connect(*world.connections, CellPath::parse("AA"), CellPath::parse("AB"), 0);
    connect(*world.connections, CellPath::parse("AB"), CellPath::parse("BA"), 0);
    changePopulation(world, Observation(world), changes);
    return pairsOf(world);
  };
  CHECK(after({none, divides, none}) == std::set<std::string>{"AA-ABB", "ABA-BA"});
  CHECK(after({divides, divides, divides}) == std::set<std::string>{"AAA-ABB", "ABA-BAB"});
}

TEST_CASE("By contact: cells that touch connect at a cycle, without a gene that asks for it") {
  using enum CellChange;
  World world = ballsAt(connecting(scenes::everybodyDivides, MakeConnections::byContact, ConnectionsOnDivision::plane),
                        {{}, {1.8, 0, 0}, {3.6, 0, 0}, {9, 0, 0}});
  connectNeighbours(world, Observation(world), {none, none, none, none});
  CHECK(pairsOf(world).empty());
  connectNeighbours(world, Observation(world), {cycled, none, none, cycled});
  CHECK(pairsOf(world) == std::set<std::string>{"AA-AB"});
  connectNeighbours(world, Observation(world), {none, cycled, none, none});
  CHECK(pairsOf(world) == std::set<std::string>{"AA-AB", "AB-BA"});
}

TEST_CASE("By contact: a gene that produces release keeps cells apart, and ends what holds") {
  const auto after = [](const std::string& gene) {
    Scene scene = connecting("START: a0\ng1(a1|a0)\ng2(divide|a0)\ng3(a2|a1)\ng4(a2|a2)\n" + gene,
                             MakeConnections::byContact, ConnectionsOnDivision::plane);
    scene.mechanics->physics.shell = ShellParameters{{1, 1, 1}};
    const World world = ranTo(scene, 3.02);
    return pairsOf(world).size();
  };
  CHECK(after("") == 1);
  CHECK(after("g5(release|a1)\n") == 1);  // cells hold `release` at cycle 2 and no longer at cycle 3
  CHECK(after("g5(release|a2)\n") == 0);
}

TEST_CASE("Pairs: only cells that touch and hold the two substances connect, whichever holds which") {
  using enum CellChange;
  const auto after = [](std::vector<ConnectedPair> pairs) {
    ConnectionParameters p = withPolicy(MakeConnections::pairs, ConnectionsOnDivision::plane);
    p.pairs = std::move(pairs);
    Scene scene = connecting("START: red1\ng1(red1|red1)\ng2(blue|blue)\ng3(green|green)\n", p);
    int i = 0;
    for (const char* substance : {"red1", "blue", "green", "red1"})
      scene.cells.push_back({.at = {1.8 * i++, 0, 0}, .substances = std::vector<std::string>{substance}});
    World world = makeWorld(scene);
    REQUIRE(pathsOf(world) == std::vector<std::string>{"AA", "AB", "BA", "BB"});
    connectNeighbours(world, Observation(world), {cycled, cycled, cycled, cycled});
    return pairsOf(world);
  };
  CHECK(after({{"red1", "blue"}}) == std::set<std::string>{"AA-AB"});
  CHECK(after({{"blue", "red*"}}) == std::set<std::string>{"AA-AB"});
  CHECK(after({{"red1", "red1"}}).empty());
  CHECK(after({{"green", "*"}}) == std::set<std::string>{"AB-BA", "BA-BB"});
}

TEST_CASE("A connection ends by age and by tension, and the cause is on record") {
  const auto causeAfter = [](const ConnectionParameters& p, double distance) {
    Scene scene = connecting(scenes::everybodyDivides, p);
    scene.mechanics->contact.reset();
    World world = ballsAt(scene, {{}, {distance, 0, 0}});
    connect(*world.connections, CellPath::parse("A"), CellPath::parse("B"), 0);
    const double end = 0.2;
    runTo(world, end);
    return std::pair{world.connections->history[0].cause, world.connections->history[0].released};
  };
  ConnectionParameters p = withPolicy(MakeConnections::atDivision, ConnectionsOnDivision::plane);
  CHECK(causeAfter(p, 2.5).first == ReleaseCause::none);
  p.releaseAge = 0.1;
  CHECK(causeAfter(p, 2.5).first == ReleaseCause::age);
  CHECK(causeAfter(p, 2.5).second == Approx(0.1).margin(0.01));
  p.strength.reset();
  p.releaseAge.reset();
  p.spring = ConnectionSpring{2, 1};
  p.releaseTension = 1;  // radii are near 0.95, so the rest length is 1.9
  CHECK(causeAfter(p, 2.2).first == ReleaseCause::none);
  CHECK(causeAfter(p, 2.6).first == ReleaseCause::tension);
  CHECK(causeAfter(p, 1.2).first == ReleaseCause::none);  // the spring is compressed
}

TEST_CASE("A cell may have so many connections that the sisters' own is left out, which comes last") {
  ConnectionParameters p = withPolicy(MakeConnections::atDivision, ConnectionsOnDivision::a);
  p.most = 2;
  World world = makeWorld(connecting(scenes::everybodyDivides, p));
  while (world.cells.path.size() < 8) step(world);
  for (const int count : countsOf(world)) CHECK(count <= 2);
  // Two rounds make the chain AB-AA-BA-BB. In the third its inner cells have no place for a connection of sisters.
  CHECK(pairsOf(world) == std::set<std::string>{"AAA-ABA", "AAA-BAA", "BAA-BBA", "ABA-ABB", "BBA-BBB"});
}

TEST_CASE("Springs between cells count against the time step") {
  ConnectionParameters p = withPolicy(MakeConnections::atDivision, ConnectionsOnDivision::plane);
  p.strength.reset();
  p.spring = ConnectionSpring{1, 1};
  const auto limitWith = [&](double stiffness) {
    p.spring->stiffness = stiffness;
    Scene scene = connecting(scenes::everybodyDivides, p);
    scene.mechanics->physics.cell = {1, 1, CellModel::sphere};
    scene.mechanics->contact.reset();
    return timeStepLimit(makeWorld(scene));
  };
  CHECK(limitWith(400) == Approx(limitWith(100) / 2).epsilon(0.1));
}

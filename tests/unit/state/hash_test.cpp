// Each single field of the state changes the hash.
#include <functional>
#include <set>

#include "catch.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

World livedWorld() { return ranTo(scenes::life(), 3.1); }

void nudge(double& x) { x = std::nextafter(x, 1e300); }
void nudge(Reals::Reference x) { x = std::nextafter(double(x), 1e300); }

struct Change {
  const char* what;
  std::function<void(World&)> make;
};

}  // namespace

TEST_CASE("A change of any field changes the hash, and no two changes give the same one") {
  const std::vector<Change> changes{
      {"nothing", [](World&) {}},
      {"time", [](World& w) { nudge(w.clock.time); }},
      {"step", [](World& w) { ++w.clock.step; }},
      {"time step", [](World& w) { nudge(w.clock.timeStep); }},
      {"epoch's time", [](World& w) { nudge(w.clock.epochTime); }},
      {"epoch's step", [](World& w) { ++w.clock.epochStep; }},
      {"x of the first vertex", [](World& w) { nudge(w.bodies->position[0]); }},
      {"z of a later one", [](World& w) { nudge(w.bodies->position[w.bodies->at(2, 41) + 2 * blockLanes]); }},
      {"the sign of a zero velocity",
       [](World& w) { w.bodies->velocity[w.bodies->at(0, 0)] = -w.bodies->velocity[w.bodies->at(0, 0)]; }},
      {"velocity", [](World& w) { nudge(w.bodies->velocity[w.bodies->at(1, 7)]); }},
      {"acceleration", [](World& w) { nudge(w.bodies->acceleration[w.bodies->at(1, 7) + blockLanes]); }},
      {"mass", [](World& w) { nudge(w.bodies->vertexMass[1]); }},
      {"rest scale", [](World& w) { nudge(w.bodies->restScale[1]); }},
      {"gas", [](World& w) { nudge(w.bodies->pressureConstant[1]); }},
      {"two cells change places",
       [](World& w) {
         std::vector<Body> cells;
         for (int i = 0; i < w.bodies->count; ++i) cells.push_back(takeBody(*w.bodies, i));
         std::swap(cells[0], cells[1]);
         setBodies(*w.bodies, cells);
       }},
      {"two vertices change places",
       [](World& w) {
         Bodies& b = *w.bodies;
         const Point third = b.vertex(0, 3);
         b.write(b.position, 0, 3, b.vertex(0, 4));
         b.write(b.position, 0, 4, third);
       }},
      {"path", [](World& w) { w.cells.path[0] = w.cells.path[0].daughter(true); }},
      {"state", [](World& w) { w.cells.state[0] = w.cells.state[1]; }},
      {"last cycle", [](World& w) { nudge(w.cells.lastCycle[0]); }},
      {"growth", [](World& w) { nudge(w.cells.growth[0]); }},
      {"a cell is gone", [](World& w) { w.cells.path.pop_back(); }},
      {"a connection's time", [](World& w) { nudge(w.connections->history[0].made); }},
      {"a connection's end", [](World& w) { nudge(w.connections->history[0].released); }},
      {"its cause", [](World& w) { w.connections->history[0].cause = ReleaseCause::gene; }},
      {"its cell", [](World& w) { w.connections->history[0].a = CellPath::parse("BBBB"); }},
      {"its other cell", [](World& w) { w.connections->history[0].b = CellPath::parse("BBBB"); }},
      {"a connection is gone", [](World& w) { w.connections->history.pop_back(); }},
      {"there are no connections", [](World& w) { w.connections.reset(); }},
      {"a birth", [](World& w) { nudge(w.lineage.entries[2].born); }},
      {"an end", [](World& w) { nudge(w.lineage.entries[0].ended); }},
      {"a birth's step", [](World& w) { ++w.lineage.entries[2].bornStep; }},
      {"an end's step", [](World& w) { ++w.lineage.entries[0].endedStep; }},
      {"a fate", [](World& w) { w.lineage.entries[0].fate = Fate::died; }},
      {"a past state", [](World& w) { w.lineage.entries[0].state = w.cells.state[0]; }},
      {"a past path", [](World& w) { w.lineage.entries[2].path = CellPath::parse("BBBB"); }},
      {"an entry is gone", [](World& w) { w.lineage.entries.pop_back(); }},
  };
  World reference = livedWorld();
  REQUIRE(reference.connections->history.size() > 1);
  REQUIRE(reference.cells.state[0] != reference.cells.state[1]);
  std::set<std::string> hashes;
  for (const auto& [what, make] : changes) {
    World world = livedWorld();
    make(world);
    CAPTURE(what);
    CHECK(hashes.insert(stateHash(world).text()).second);
  }
}

TEST_CASE("A change shows in the part where it was made, and in no other") {
  const World reference = livedWorld();
  const StateHashes before = hashState(reference);
  const auto cellsThatChange = [&](const std::function<void(World&)>& make, bool clock, bool connections,
                                   bool lineage) {
    World world = livedWorld();
    make(world);
    const StateHashes after = hashState(world);
    CHECK((after.clock != before.clock) == clock);
    CHECK((after.connections != before.connections) == connections);
    CHECK((after.lineage != before.lineage) == lineage);
    CHECK(after.whole != before.whole);
    CHECK(hashWhole(after) == after.whole);
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < after.cells.size(); ++i)
      if (!(after.cells[i] == before.cells[i])) cells.push_back(i);
    return cells;
  };
  using Cells = std::vector<std::size_t>;
  CHECK(cellsThatChange([](World& w) { nudge(w.clock.time); }, true, false, false) == Cells{});
  CHECK(cellsThatChange([](World& w) { nudge(w.bodies->velocity[w.bodies->at(1, 7)]); }, false, false, false) ==
        Cells{1});
  CHECK(cellsThatChange([](World& w) { w.cells.state[0] = w.cells.state[1]; }, false, false, false) == Cells{0});
  CHECK(cellsThatChange([](World& w) { w.connections->history[0].cause = ReleaseCause::age; }, false, true, false) ==
        Cells{});
  CHECK(cellsThatChange([](World& w) { nudge(w.lineage.entries[2].born); }, false, false, true) == Cells{});
}

TEST_CASE("A link vouches for its state, its step and all links before") {
  const World world = livedWorld();
  const ChainLink first = nextLink({}, world), second = nextLink(first.hash, world);
  CHECK(first.step == world.clock.step);
  CHECK(first.state == hashState(world));
  CHECK(first.hash != second.hash);
  CHECK(second.hash == hashLink(first.hash, world.clock.step, stateHash(world)));
  CHECK(hashLink(first.hash, 7, stateHash(world)) != second.hash);
  CHECK(hashLink(first.hash, world.clock.step, first.hash) != second.hash);
}

TEST_CASE("The hash changes with every step") {
  World world = makeWorld(scenes::life(), {Isa::scalar, 1});
  std::set<std::string> hashes{stateHash(world).text()};
  for (int i = 0; i < 200; ++i) {
    step(world);
    CHECK(hashes.insert(stateHash(world).text()).second);
  }
}

TEST_CASE("What is only speed or scratch is not in the hash") {
  World world = livedWorld();
  const Hash before = stateHash(world);
  world.contacts->listIsValid = false;
  world.contacts->rebuilds += 5;
  world.bodies->scratch[0].gradient[0] = 1;
  world.bodies->volume[0] = 7;
  world.bodies->position[world.bodies->position.size() - 1] = 9;  // belongs to a lane without a cell
  CHECK(stateHash(world) == before);
}

TEST_CASE("A state that holds no number is a failed run, not a hash") {
  World world = livedWorld();
  world.bodies->velocity[world.bodies->at(0, 0)] = std::nan("");
  CHECK_THROWS_AS(stateHash(world), NumericalError);
}

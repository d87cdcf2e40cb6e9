// A run that is saved at any step and restored in another world, on other machines, continues bit for bit, down to the
// counters.
#include <map>
#include <set>

#include "base/random.h"
#include "catch.h"
#include "simulation/restore.h"
#include "unit/simulation/worlds.h"

using namespace morula;

namespace {

std::vector<Scene> savedScenes() {
  using namespace scenes;
  std::vector<Scene> all{life(),    packed(), ellipsoid(), thesis(),  coarsening(),           lineageOnly(eventful, 6),
                         spheres(), sticky(), sensing(),   turning(), inSingle(lifeOfRings())};
  all.push_back(ellipsoid());
  all.back().mechanics->physics.integrator = Integrator::rungeKutta4;
  for (const Scene& scene : {ellipsoid(), coarsening()}) all.push_back(byPositions(scene, 2));
  for (const Scene& scene : {life(), coarsening()}) all.push_back(byShapes(scene));
  for (const Scene& events : {packed(), sticky(), spheres(), coarsening()})
    all.push_back(settling(events));
  return all;
}

/// Returns up to twenty steps of a run, random but reproducible.
std::set<std::uint64_t> chosenSteps(std::uint64_t last) {
  std::set<std::uint64_t> steps;
  for (std::uint32_t i = 0; i < 20; ++i)
    steps.insert(static_cast<std::uint64_t>(randomUnit({42, {}, 0, Purpose::test}, i) * double(last)));
  return steps;
}

/// Returns the i-th way to execute a world, going through all of them in turn.
Execution executionNumber(std::size_t i) {
  const std::vector<Isa> isas = availableIsas();
  return {isas[i % isas.size()], static_cast<int>(1 + i % 3)};
}

bool sameContacts(const World& a, const World& b) {
  const auto p = measureContacts(a), q = measureContacts(b);
  return p.size() == q.size() && std::equal(p.begin(), p.end(), q.begin(), [](const auto& x, const auto& y) {
           return x.a == y.a && x.b == y.b && x.at("area") == y.at("area");
         });
}

}  // namespace

TEST_CASE("From a checkpoint at any step, the run goes on as if it had never stopped") {
  for (const Scene& scene : savedScenes()) {
    const std::uint64_t last = ranToEnd(scene).clock.step;
    std::map<std::uint64_t, std::string> checkpoints;
    World world = makeWorld(scene);
    const std::set<std::uint64_t> steps = chosenSteps(last);
    std::size_t number = 0;
    for (; !finished(world); step(world)) {
      if (!steps.contains(world.clock.step)) continue;
      const std::string saved = checkpoints[world.clock.step] = saveState(world);
      World restored = makeWorld(scene, executionNumber(number++));
      restoreState(restored, saved);
      CAPTURE(scene.name, world.clock.step);
      CHECK(stateHash(restored) == stateHash(world));
      CHECK((saveState(restored) == saved));
      CHECK(sameContacts(restored, world));
    }
    CHECK(checkpoints.size() == steps.size());
    const Hash hash = stateHash(world);
    checkpoints[world.clock.step] = saveState(world);
    // Each checkpoint runs to the second one after it, and every fourth to the end, so that missing state shows.
    std::size_t place = 0;
    for (auto from = checkpoints.begin(); std::next(from) != checkpoints.end(); ++from, ++place) {
      const bool whole = place % 4 == 0 || checkpoints.size() - place <= 3;
      const auto to = whole ? std::prev(checkpoints.end()) : std::next(from, 2);
      World restored = makeWorld(scene, executionNumber(number++));
      restoreState(restored, from->second);
      while (!finished(restored) && (whole || restored.clock.step < to->first)) step(restored);
      CAPTURE(scene.name, from->first, to->first);
      CHECK((saveState(restored) == to->second));  // including the history of time steps and all counters
      if (!whole) continue;
      CHECK(stateHash(restored) == hash);
      CHECK((restored.divisions == world.divisions));
    }
  }
}

TEST_CASE("Right after a cell cycle with growth, what touches is still what the last step saw") {
  World world = makeWorld(scenes::life());
  int stale = 0;
  while (!finished(world)) {
    step(world);
    if (world.contacts->listIsValid) continue;
    ++stale;
    World restored = makeWorld(scenes::life(), {Isa::scalar, 1});
    restoreState(restored, saveState(world));
    CHECK(sameContacts(restored, world));
    CHECK((saveState(restored) == saveState(world)));
  }
  CHECK(stale > 0);
}

TEST_CASE("A checkpoint of an organism whose cells have all died") {
  const Scene scene = [] {
    Scene s = scenes::life();
    s.dna = parseDna("START: a0\ng1(die|a0)\n", "test.dna");
    return s;
  }();
  const World world = ranToEnd(scene);
  REQUIRE(world.cells.path.empty());
  World restored = makeWorld(scene, {Isa::scalar, 1});
  restoreState(restored, saveState(world));
  CHECK(finished(restored));
  CHECK((saveState(restored) == saveState(world)));
}

TEST_CASE("A state may be gone on with for longer than was planned") {
  const Scene scene = scenes::life();
  Scene longer = scene;
  longer.stop.cycles = 7;
  World restored = makeWorld(longer);
  restoreState(restored, saveState(ranToEnd(scene)));
  runToEnd(restored);
  CHECK(stateHash(restored) == stateHash(ranToEnd(longer)));
}

TEST_CASE("A state that was restored once can be restored over another one") {
  const Scene scene = scenes::coarsening();
  const std::string early = saveState(ranTo(scene, 0.5)), late = saveState(ranTo(scene, 3));
  World world = makeWorld(scene);
  for (const std::string& saved : {late, early, late}) {
    restoreState(world, saved);
    CHECK((saveState(world) == saved));
  }
}

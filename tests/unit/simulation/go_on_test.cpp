// A run that has ended goes on, to a later stop or with further experiments, as the whole scene does from its start.
#include "simulation/go_on.h"

#include <map>
#include <string>

#include "catch.h"
#include "scenes.h"
#include "state/checkpoint.h"
#include "worlds.h"

using namespace morula;

namespace {

const Execution plain{Isa::scalar, 1};

Scene stoppedAt(Scene scene, const StopParameters& stop) {
  scene.stop = stop;
  return scene;
}

Scene with(Scene scene, const Experiment& experiment) {
  scene.experiments.push_back(experiment);
  return scene;
}

/// Returns the last state before the scene's stop.
std::string beforeStop(const Scene& scene, const Execution& how = plain) {
  World world = makeWorld(scene, how);
  std::string state;
  while (!finished(world)) state = saveState(world), step(world);
  return state;
}

Hash endFrom(const std::string& state, const Scene& scene, std::size_t added, const Execution& how = plain) {
  World world = makeWorld(scene, how);
  goOnFrom(world, state, added);
  runToEnd(world);
  return hashState(world).whole;
}

Hash endFromStart(const Scene& scene) { return hashState(ranToEnd(scene, plain)).whole; }

CellSelection cellAt(const char* path) { return {.kind = CellSelection::Kind::cell, .path = CellPath::parse(path)}; }
CellSelection cloneAt(const char* path) { return {.kind = CellSelection::Kind::clone, .path = CellPath::parse(path)}; }

}  // namespace

TEST_CASE("A run that has stopped goes on to a later stop with the bits of one run") {
  std::map<std::string, Scene> scenes{{"life", scenes::life()},
                                      {"spheres with a step of their own", scenes::spheres()},
                                      {"isolated cells", scenes::withBodies(scenes::everybodyDivides, 3)},
                                      {"genes alone", scenes::lineageOnly(scenes::everybodyDivides, 3)},
                                      {"at rest", scenes::settling(scenes::spheres())},
                                      {"quasi-static", scenes::settling(scenes::packed())}};
  // The first time lies between two steps, so that the last step before it is shorter than the others.
  const StopParameters stops[] = {{.time = 2.2999}, {.cycles = 2}, {.cells = 3}, {.cells = 4}};
  for (auto& [name, whole] : scenes) {
    if (!whole.mechanics || !whole.mechanics->physics.timeStep) whole.stop = {.time = 3.3};
    else whole.stop = {.time = 3.25};
    const Hash expected = endFromStart(whole);
    for (const StopParameters& stop : stops) {
      CAPTURE(name, stop.time, stop.cycles, stop.cells);
      CHECK(endFrom(beforeStop(stoppedAt(whole, stop)), whole, 0) == expected);
    }
  }
}

TEST_CASE(
    "A run that goes on with an experiment has the bits of the scene with that experiment, whatever kernels run") {
  constexpr double time = 2.2999;
  const Experiment changes[] = {{.deed = Deed::kill, .of = {cloneAt("B")}, .at = time},
                                {.deed = Deed::geneOff, .name = "g18", .at = time},
                                {.deed = Deed::set, .name = "physics.drag", .value = 5, .at = time},
                                {.deed = Deed::cycles, .of = {cloneAt("A")}, .value = 1.1, .at = time},
                                {.deed = Deed::delay, .value = 0.3, .share = 0.5, .at = time},
                                {.deed = Deed::connect, .of = {cloneAt("A"), cloneAt("B")}, .at = time},
                                {.deed = Deed::release, .of = {cloneAt("A"), cloneAt("A")}, .at = time}};
  const Scene mother = stoppedAt(scenes::life(), {.time = time}), later = stoppedAt(scenes::life(), {.time = 3.3});
  const Hash unchanged = endFromStart(later);
  const std::string states[] = {beforeStop(mother), beforeStop(mother, {bestIsa(), 2})};
  for (const Experiment& change : changes) {
    CAPTURE(nameOf(change.deed));
    const Scene changed = with(later, change);
    const Hash expected = endFromStart(changed);
    CHECK(expected != unchanged);
    for (const std::string& state : states)
      for (const Execution& how : {plain, Execution{Isa::scalar, 2}, {Isa::narrow, 1}, {bestIsa(), 1}, {bestIsa(), 2}})
        CHECK(endFrom(state, changed, 1, how) == expected);
  }
  // A second experiment after one that was done, and one that waits for births.
  const Scene twice = with(with(later, changes[2]), {.deed = Deed::kill, .of = {cloneAt("A")}, .at = 3});
  CHECK(endFrom(beforeStop(stoppedAt(with(later, changes[2]), {.time = 2.9})), twice, 1) == endFromStart(twice));
  const Scene born = with(later, {.deed = Deed::delay, .of = {cloneAt("A")}, .value = 0.1, .afterBirth = 2.5});
  CHECK(endFrom(states[0], born, 1) == endFromStart(born));
}

TEST_CASE("A run does not go on where its past would have been another") {
  const Scene scene = stoppedAt(scenes::packed(), {.time = 3.5});
  const std::string state = beforeStop(stoppedAt(scene, {.time = 2.5}));
  const auto refusal = [&](const Scene& other, std::size_t added) -> std::string {
    World world = makeWorld(other, plain);
    const Hash before = hashState(world).whole;
    try {
      goOnFrom(world, state, added);
    } catch (const InputError& error) {
      CHECK(hashState(world).whole == before);
      return error.what();
    }
    return "";
  };
  CHECK(refusal(scene, 0).empty());
  CHECK_THAT(refusal(stoppedAt(scene, {.time = 2}), 0), ContainsSubstring("stop at time 2 is not after time 2.4"));
  CHECK_THAT(refusal(stoppedAt(scene, {.time = 9, .cells = 4}), 0), ContainsSubstring("stop.cells 4: so many cells"));
  CHECK(refusal(stoppedAt(scene, {.time = 9, .cells = 5}), 0).empty());
  const auto kill = [&](Experiment e) {
    e.of = {cellAt("AA")};
    return refusal(with(scene, e), 1);
  };
  CHECK_THAT(kill({.at = 1.5}), ContainsSubstring("experiments[0].kill is due, or may be, before time 2.4"));
  CHECK(kill({.at = 2.5}).empty());
  CHECK_THAT(kill({.atCells = 4}), ContainsSubstring("experiments[0].kill"));
  CHECK(kill({.atCells = 5}).empty());
  CHECK_THAT(kill({.afterBirth = 0.25}), ContainsSubstring("experiments[0].kill"));
  CHECK(kill({.afterBirth = 0.75}).empty());
  CHECK_THAT(refusal(with(scene, {.of = {cellAt("AA")}, .at = 2.5}), 0), ContainsSubstring("differs in: experiments"));
  Scene stiffer = scene;
  stiffer.mechanics->physics.membrane.stiffness *= 2;
  CHECK_THAT(refusal(stiffer, 0), ContainsSubstring("differs in: physics"));
}

// The search for contacts changes the speed, never a bit of the result.
#include "catch.h"
#include "worlds.h"

using namespace morula;

namespace {

/// The last state's hash, and how many steps and searches led to it.
struct End {
  Hash hash;
  std::uint64_t steps, rebuilds;
};

End endOf(const Scene& scene, const Execution& how) {
  const World world = ranToEnd(scene, how);
  return {stateHash(world), world.clock.step, world.contacts->rebuilds};
}

Scene shortPacked() {
  Scene scene = scenes::packed();
  scene.stop.time = 3.25;  // eight cells, and the first steps of sixteen
  return scene;
}

}  // namespace

TEST_CASE(
    "Packed cells end in one state, whichever way, instruction set and number of threads found who touches whom") {
  const Scene scene = shortPacked();
  const End expected = endOf(scene, {Isa::scalar, 1, {ContactSearch::bruteForce, 0.15}});
  CHECK(expected.rebuilds > 10);
  for (ContactSearch search : valuesOf<ContactSearch>())
    for (Isa isa : availableIsas())
      for (int threads : {1, 3}) {
        if (search == ContactSearch::bruteForce && isa != bestIsa()) continue;  // brute force has no kernels
        const End end = endOf(scene, {isa, threads, {search, 0.15}});
        CAPTURE(nameOf(search), name(isa), threads);
        CHECK(end.hash == expected.hash);
        CHECK(end.rebuilds == expected.rebuilds);
      }
}

TEST_CASE("Any skin leads to the same state: only the number of searches differs") {
  const Scene scene = shortPacked();
  const End usual = endOf(scene, {});
  for (double skinShare : {0.0, 0.02, 0.5}) {
    const End end = endOf(scene, {bestIsa(), 1, {ContactSearch::grid, skinShare}});
    CAPTURE(skinShare);
    CHECK(end.hash == usual.hash);
    if (skinShare == 0) CHECK(end.rebuilds >= end.steps);
    else CHECK((end.rebuilds > usual.rebuilds) == (skinShare < SearchSettings{}.skinShare));
  }
}

TEST_CASE("Births and deaths, growth and connections: trees like grids, step by step") {
  const Scene scene = scenes::life();
  World grid = makeWorld(scene), trees = makeWorld(scene, {bestIsa(), 2, {ContactSearch::aabbTree, 0}}),
        hashed = makeWorld(scene, {bestIsa(), 1, {ContactSearch::spatialHash, 0.3}});
  std::int64_t different = 0;
  while (!finished(grid)) {
    step(grid), step(trees), step(hashed);
    const Hash h = stateHash(grid);
    different += h != stateHash(trees) || h != stateHash(hashed);
  }
  CHECK(different == 0);
  CHECK(grid.lineage.entries.size() >= 7);
}

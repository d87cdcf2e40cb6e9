// The worm's embryo to 28 cells: its stages, what is known of its contacts, and its mirror image.
#include <cmath>
#include <iostream>
#include <set>

#include "base/parallel.h"
#include "catch.h"
#include "organism/mirrored.h"

using namespace morula;

namespace {

Scenario embryo(const std::vector<std::string>& changes = {}) {
  std::vector<Override> overrides;
  for (const std::string& change : changes) overrides.push_back(parseOverride(change));
  return loadScenario(MORULA_SOURCE_DIR "/scenarios/worm/embryo.yaml", overrides);
}

bool touch(const World& world, const CellNames& names, const std::string& a, const std::string& b) {
  for (const ContactMeasures& pair : measureContacts(world)) {
    const std::set<std::string> both{names.of(pair.a).value_or(""), names.of(pair.b).value_or("")};
    if (both == std::set<std::string>{a, b}) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("the embryo goes through the stages of 4, 6, 7, 8, 12, 15, 24, 26 and 28 cells, in ten seeds") {
  std::vector<std::vector<std::size_t>> stages(10);
  std::vector<int> pharynx(10);  // cells told by MS that they will make it
  parallelFor(10, 2, [&](int i) {
    const Scenario scenario = embryo({"seed=" + std::to_string(i + 1)});
    World world = makeWorld(scenario.scene);
    stages[i].push_back(world.cells.path.size());
    const double twelve = 14.5;  // [time] as long before MS divides as the contacts take to settle
    while (!finished(world)) {
      step(world);
      if (world.cells.path.size() != stages[i].back()) stages[i].push_back(world.cells.path.size());
      if (pharynx[i] == 0 && world.clock.time >= twelve)
        pharynx[i] = 1 + touch(world, scenario.names, "ABalp", "MS") + touch(world, scenario.names, "ABara", "MS");
    }
  });
  int told = 0;
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i, stages[i]);
    std::size_t at = 0;
    for (const std::size_t wanted : {4, 6, 7, 8, 12, 15, 24, 26, 28}) {
      while (at < stages[i].size() && stages[i][at] != wanted) ++at;
      CHECK(at < stages[i].size());
    }
    CHECK(stages[i].back() == 28);
    told += pharynx[i] - 1;
  }
  CAPTURE(told);
  CHECK(told >= 18);  // [Hutter & Schnabel 1994]: both, in every embryo
}

TEST_CASE("mirrored rules give the mirrored embryo") {
  using namespace mirrored;
  const Scene scene = withoutSeed(embryo({"stop.time=13"}).scene);
  World world = makeWorld(scene), image = makeWorld(mirror(scene, Axis::z));
  while (!finished(world)) step(world), step(image);
  REQUIRE(finished(image));
  CHECK(world.cells.path.size() == 8);
  REQUIRE(world.lineage.entries.size() == image.lineage.entries.size());
  for (std::size_t i = 0; i < world.lineage.entries.size(); ++i) {
    CHECK(world.lineage.entries[i].path == image.lineage.entries[i].path);
    CHECK(world.lineage.entries[i].born == image.lineage.entries[i].born);
  }
  // Sums around a mirrored ring run the other way; eight cells have had no time to make much of it.
  CHECK(difference(world, image, Axis::z) < 1e-6);
}

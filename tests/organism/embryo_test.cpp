// The worm's embryo to 28 cells: its stages, its known contacts, its distance from real embryos, and its mirror image.
#include <cmath>
#include <iostream>
#include <set>

#include "base/parallel.h"
#include "catch.h"
#include "observation/organism_measures.h"
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

/// A stage of the real embryo, in the middle between two divisions.
struct Stage {
  std::size_t cells;
  double middle;  // [time]
  Reference real;
};

std::vector<Stage> realStages() {
  std::vector<Stage> stages;
  for (const auto& [cells, middle] : {std::pair(4, 7.6), std::pair(8, 12.0), std::pair(12, 13.8), std::pair(15, 16.7)})
    stages.push_back({std::size_t(cells), middle,
                      *embryo({"check.reference.file=real/" + std::to_string(cells) + ".txt"}).check.reference});
  return stages;
}

/// Returns the pairs that touch over more than 5 % of the mean contact, as tests of four cells count contacts.
std::set<std::pair<CellPath, CellPath>> clearContacts(const World& world) {
  const auto contacts = measureContacts(world);
  double mean = 0;
  for (const ContactMeasures& pair : contacts) mean += pair.at("area") / static_cast<double>(contacts.size());
  std::set<std::pair<CellPath, CellPath>> clear;
  for (const ContactMeasures& pair : contacts)
    if (pair.at("area") > 0.05 * mean) clear.insert(std::minmax(pair.a, pair.b));
  return clear;
}

/// The comparison of an embryo with the real one in the middle of a stage.
struct Nearness {
  double distance = 0, f1 = 0;  // [µm], [1]
  std::set<std::pair<CellPath, CellPath>> contacts;
};

const double radius = 17.05;  // [µm] of the egg, whose volume is 20769 µm³

Nearness nearnessOf(const World& world, const Stage& stage) {
  Observation now(world);
  now.reference = &stage.real;
  const auto contacts = compareContacts(now);
  const auto positions = comparePositions(now);
  Nearness found{positions.value().distance * radius, 2 * contacts.both / (contacts.here + contacts.there),
                 clearContacts(world)};
  if (world.cells.path.size() != stage.cells) found.distance = HUGE_VAL;
  return found;
}

/// The results of one seed.
struct Embryo {
  std::vector<Nearness> near;       // one per stage
  std::vector<std::size_t> counts;  // numbers of cells in their order
  int pharynx = 0;                  // number of cells that MS tells to make pharynx
};

/// Grows an embryo to its end, or past the last stage.
Embryo grow(int seed, const std::vector<Stage>& stages, bool whole) {
  const Scenario scenario = embryo({"seed=" + std::to_string(seed)});
  World world = makeWorld(scenario.scene);
  Embryo grown;
  grown.counts.push_back(world.cells.path.size());
  const double twelve = 14.5;  // [time] contacts have settled; MS divides later
  bool asked = false;
  while (!finished(world) && (whole || grown.near.size() < stages.size())) {
    step(world);
    if (world.cells.path.size() != grown.counts.back()) grown.counts.push_back(world.cells.path.size());
    if (grown.near.size() < stages.size() && world.clock.time >= stages[grown.near.size()].middle)
      grown.near.push_back(nearnessOf(world, stages[grown.near.size()]));
    if (asked || world.clock.time < twelve) continue;
    asked = true;
    grown.pharynx = touch(world, scenario.names, "ABalp", "MS") + touch(world, scenario.names, "ABara", "MS");
  }
  return grown;
}

/// Grows the embryo under the seeds 1 to `ofAll` to 15 cells, and the first `whole` of them to 28, and compares them
/// with real ones.
void compareWithReal(int ofAll, int whole) {
  const auto stages = realStages();
  std::vector<Embryo> seeds(ofAll);
  parallelFor(ofAll, 2, [&](int i) { seeds[i] = grow(i + 1, stages, i < whole); });
  // The reference of eight cells lacks the three smallest faces of real embryos, a quarter of the mean at most: these
  // contacts may be there or not. The next smallest face is 0.7 of the mean.
  const auto names = embryo().names;
  std::set<std::pair<CellPath, CellPath>> small;
  for (const auto& [a, b] : {std::pair("ABar", "C"), std::pair("ABpl", "ABpr"), std::pair("ABpr", "P3")})
    small.insert(std::minmax({cellCalled(names, a, ""), cellCalled(names, b, "")}));
  for (int i = 0; i < ofAll; ++i) {
    CAPTURE(i + 1);
    REQUIRE(seeds[i].near.size() == stages.size());
    CHECK(seeds[i].near[0].contacts == stages[0].real.contacts);
    auto eight = seeds[i].near[1].contacts;
    for (const auto& pair : small) eight.erase(pair);
    CHECK(eight == stages[1].real.contacts);
  }
  Nearness mean[4];
  for (const Embryo& seed : seeds)
    for (int s = 0; s < 4; ++s)
      mean[s].distance += seed.near[s].distance / ofAll, mean[s].f1 += seed.near[s].f1 / ofAll;
  for (int s = 0; s < 4; ++s)
    std::cout << stages[s].cells << " cells: " << mean[s].distance << " µm, F1 " << mean[s].f1 << '\n';
  CHECK(mean[2].f1 >= 0.87);
  CHECK(mean[2].distance <= 3.65);  // [µm] 3.60 with all seeds, 3.64 with a damping of 0.02; real embryos differ by 2.3
  CHECK(mean[3].distance <= 4.2);   // [µm] real embryos differ among themselves by 2.0
  int told = 0;
  for (int i = 0; i < whole; ++i) {
    const auto& counts = seeds[i].counts;
    CAPTURE(i + 1, counts);
    std::size_t at = 0;
    for (const std::size_t wanted : {4, 6, 7, 8, 12, 15, 24, 26, 28}) {
      while (at < counts.size() && counts[at] != wanted) ++at;
      CHECK(at < counts.size());
    }
    CHECK(counts.back() == 28);
    told += seeds[i].pharynx;
  }
  CAPTURE(told);
  CHECK(told >= 2 * whole - whole / 5);  // [Hutter & Schnabel 1994]: both, in every embryo
}

}  // namespace

TEST_CASE(
    "four and eight cells touch as in the real embryo; 12 and 15 lie near its places; all stages are gone through") {
  compareWithReal(4, 2);
}

TEST_CASE(
    "four and eight cells touch as in the real embryo, in 20 of 20 seeds; 12 and 15 lie near its places; ten seeds go through "
    "the stages of 4, 6, 7, 8, 12, 15, 24, 26 and 28 cells",
    "[.][all-seeds]") {
  compareWithReal(20, 10);
}

TEST_CASE("mirrored rules give the mirrored embryo") {
  using namespace mirrored;
  Scene scene = withoutSeed(embryo({"stop.time=13"}).scene);
  // P0 divides along the egg, 3 degrees from its measured axis. With the measured axis rounding decides a cut, and
  // otherwise in the mirror: a change of the axis by 1e-15 moves four cells by 0.02 radii. The cause is unknown,
  // perhaps a fold of the flat side (division/halves.h).
  scene.mechanics->division.rules.at(0).plane->axis = {-1, 0, 0};
  World world = makeWorld(scene), image = makeWorld(mirror(scene, Axis::z));
  while (!finished(world)) step(world), step(image);
  REQUIRE(finished(image));
  CHECK(world.cells.path.size() == 8);
  REQUIRE(world.lineage.entries.size() == image.lineage.entries.size());
  for (std::size_t i = 0; i < world.lineage.entries.size(); ++i) {
    CHECK(world.lineage.entries[i].path == image.lineage.entries[i].path);
    CHECK(world.lineage.entries[i].born == image.lineage.entries[i].born);
  }
  // Sums around a mirrored ring run the other way; this difference is still small at eight cells.
  CHECK(difference(world, image, Axis::z) < 1e-6);
}

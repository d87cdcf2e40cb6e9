// Cleavage patterns whose counts and places are known exactly: sea urchin, spiral cleavage, Volvox.
#include <cmath>
#include <map>
#include <numbers>

#include "catch.h"
#include "organism/mirrored.h"

using namespace morula;
using namespace mirrored;

namespace {

Scene sceneOf(const std::string& name) {
  return loadScenario(MORULA_SOURCE_DIR "/scenarios/patterns/" + name + ".yaml").scene;
}

World runToEnd(const Scene& scene) {
  World world = makeWorld(scene);
  while (!finished(world)) step(world);
  return world;
}

struct Kind {
  int count = 0;
  double volume = 0, lowest = INFINITY, highest = -INFINITY;  // [length³] of all cells; [length] z of centres
};

/// Groups cells by the substances that they hold.
std::map<std::string, Kind> kindsOf(const World& world) {
  std::map<std::string, Kind> kinds;
  for (const CellMeasures& cell : measureCells(world)) {
    Kind& kind = kinds[world.biology->describe(cell.state)];
    ++kind.count;
    kind.volume += cell.at("volume");
    kind.lowest = std::min(kind.lowest, cell.at("z"));
    kind.highest = std::max(kind.highest, cell.at("z"));
  }
  return kinds;
}

/// Returns the angle [degree] about the z axis from daughter B to daughter A, for each divided cell at this depth.
/// Angles are positive anticlockwise, seen from +z.
std::vector<double> twists(const World& world, int depth) {
  const auto cells = measureCells(world);
  std::vector<double> all;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    const CellPath& path = cells[i].path;
    if (path.depth() != depth + 1 || path.letter(depth)) continue;
    const Point a = centreOf(cells[i]), b = centreOf(cells[i + 1]);
    double angle = (std::atan2(a.y, a.x) - std::atan2(b.y, b.x)) * 180 / std::numbers::pi;
    if (angle > 180) angle -= 360;
    if (angle < -180) angle += 360;
    all.push_back(angle);
  }
  return all;
}

}  // namespace

TEST_CASE("sea urchin: 8 mesomeres, 4 macromeres and 4 micromeres, from pole to pole") {
  auto kinds = kindsOf(runToEnd(sceneOf("urchin")));
  REQUIRE(kinds.size() == 3);
  const Kind &meso = kinds["mesomere"], &macro = kinds["macromere"], &micro = kinds["micromere"];
  CHECK(meso.count == 8);
  CHECK(macro.count == 4);
  CHECK(micro.count == 4);
  CHECK(micro.highest < macro.lowest);
  CHECK(macro.highest < meso.lowest);
  CHECK(macro.volume / 4 > meso.volume / 8);
  CHECK(micro.volume < 0.2 * macro.volume);
}

TEST_CASE("sea urchin: the third cleavage also succeeds from starts that differ by a millionth of a radius") {
  // Formerly the time step ignored pairs of vertices that contacts hold at the end of their reach. Runs with these
  // seeds then failed before time 9.2 with "it is pressed into".
  for (const std::uint64_t seed : {3, 4, 6, 7, 8, 9}) {
    Scene scene = sceneOf("urchin");
    scene.seed = seed, scene.variation.start = 1e-6, scene.stop.time = 9.5;
    CAPTURE(seed);
    CHECK(runToEnd(scene).cells.path.size() == 8);
  }
}

TEST_CASE("spiral cleavage turns clockwise with the third division and anticlockwise with the fourth") {
  Scene scene = sceneOf("spiral");
  scene.stop.time = 11.9;
  const auto third = twists(runToEnd(scene), 2);
  REQUIRE(third.size() == 4);
  for (double angle : third) CHECK(std::abs(angle + 45) < 15);
  const auto fourth = twists(runToEnd(sceneOf("spiral")), 3);
  REQUIRE(fourth.size() == 8);
  for (double angle : fourth) CHECK(std::abs(angle - 45) < 15);
}

TEST_CASE("spiral cleavage in the mirror is that of a left-handed snail") {
  Scene scene = withoutSeed(sceneOf("spiral"));
  const auto apart = [&] { return difference(runToEnd(scene), runToEnd(mirror(scene, Axis::y)), Axis::y); };
  CHECK(apart() < 1e-4);  // rounding grows to 6e-6 in the packing of 16 cells
  scene.stop.time = 8;    // four cells
  CHECK(apart() < 1e-9);
}

TEST_CASE("Volvox: 16 gonidia, larger than any other cell") {
  const World world = runToEnd(sceneOf("volvox"));
  auto kinds = kindsOf(world);
  CHECK(kinds["gonidium"].count == 16);
  CHECK(kinds["soma"].count == 48);
  double smallest = INFINITY, largest = 0;
  for (const CellMeasures& cell : measureCells(world))
    if (world.biology->describe(cell.state) == "gonidium") smallest = std::min(smallest, cell.at("volume"));
    else largest = std::max(largest, cell.at("volume"));
  CHECK(smallest > largest);
}

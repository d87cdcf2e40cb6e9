// Compares runs with level of detail with the fine run: savings and errors.
#include <cmath>

#include "catch.h"
#include "observation/body_measures.h"
#include "observation/measures.h"
#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "worst.h"

using namespace morula;

namespace {

struct CountedRun {
  World world;
  double vertexSteps = 0;

  explicit CountedRun(const Scene& scene) : world(makeWorld(scene)) {
    while (!finished(world)) {
      step(world);
      vertexSteps += world.bodies->livingVertices;
    }
  }
};

Point centreOf(const CellMeasures& m) { return {m.at("x"), m.at("y"), m.at("z")}; }

}  // namespace

TEST_CASE("coarsening: five cells lie, and are as large, as in the fine run, for less than a third of the work") {
  const std::string file = MORULA_SOURCE_DIR "/scenarios/organisms/coarsening.yaml";
  const Scene scene = loadScenario(file, {parseOverride("stop.time=3.9375")}).scene;
  Scene fineScene = scene;
  fineScene.mechanics->physics.coarsen.reset();
  fineScene.mechanics->coarser.clear();
  const CountedRun coarse(scene), fine(fineScene);

  const auto a = measureCells(coarse.world), b = measureCells(fine.world);
  // Later, rounding decides which axis of a nearly round cell is its longest, and a coarser mesh decides otherwise.
  REQUIRE(a.size() == 5);
  REQUIRE(b.size() == 5);
  Worst centre, volume, area;
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].path == b[i].path);
    const double radius = std::cbrt(3 * b[i].at("volume") / 12.566370614359172);
    const double distance = norm(centreOf(a[i]) - centreOf(b[i])) / radius;
    centre.see(distance);
    sum += distance;
    volume.see(std::abs(a[i].at("volume") / b[i].at("volume") - 1));
    area.see(std::abs(a[i].at("area") / b[i].at("area") - 1));
  }
  CAPTURE(sum / 5, double(centre), double(volume), double(area), fine.vertexSteps / coarse.vertexSteps);
  CHECK(sum / 5 < 0.05);  // [cell radii]
  CHECK(centre < 0.1);
  CHECK(volume < 0.03);  // viscosity in the packing is chaotic by now: one cell reaches 0.023
  CHECK(area < 0.02);
  CHECK(coarse.world.bodies->livingVertices == 642 + 4 * 162);
  CHECK(fine.vertexSteps > 3 * coarse.vertexSteps);
  CHECK(measureMeanOverlap(*coarse.world.bodies, coarse.world.contacts.get()) < 0.01);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i].at("sphericity") > 0.75);
}

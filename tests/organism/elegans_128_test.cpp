// The thesis' figure 5.6 as a whole: one cell becomes 128 packed ones in the egg shell.
#include <cmath>

#include "catch.h"
#include "scenario/scenario.h"
#include "simulation/body_measures.h"
#include "simulation/measures.h"
#include "simulation/world.h"

using namespace morula;

TEST_CASE("elegans-128: 128 cells fill the shell; none escapes, inverts or overlaps much") {
  const auto scenario = loadScenario(MORULA_SOURCE_DIR "/scenarios/thesis/elegans-128.yaml");
  World world = makeWorld(scenario.scene);
  double outermost = 0, smallest = INFINITY;
  while (!finished(world)) {
    step(world);
    for (int slot = 0; slot < world.bodies->count; ++slot)
      smallest = std::min(smallest, world.bodies->volume[slot] * world.bodies->count);
    if (world.clock.step % 8 == 0) outermost = std::max(outermost, measureWorld(world).at("outermost"));
  }
  const WorldMeasures end = measureWorld(world);
  CHECK(end.at("cells") == 128);
  CHECK(std::max(outermost, end.at("outermost")) <= 1 + 1e-6);  // every vertex inside, in shell radii
  CHECK(smallest > 1.0);  // times the cells, so of the egg's 4.05: no cell came near to turning inside out
  CHECK(end.at("shell_fill") >= 0.85);
  CHECK(measureMeanOverlap(*world.bodies) < 0.02);
  for (const CellMeasures& cell : measureCells(world)) {
    INFO(cell.path.text());
    CHECK(cell.at("sphericity") > 0.6);  // a cube has 0.81, a turned or crumpled cell far less
  }
}

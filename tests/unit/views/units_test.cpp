// Charts in the units of the scenario.
#include "catch.h"
#include "views/run_charts.h"

using namespace morula;

TEST_CASE("a chart and its axes are in the scenario's units; what holds a force stays") {
  RunResults results;
  for (const double time : {0.0, 1.5}) {
    Sample sample;
    sample.world.time = time, sample.world["volume"] = 2, sample.world["mean_pressure"] = 5;
    results.samples.push_back(sample);
  }
  Scenario scenario;
  scenario.scene.name = "small";
  const Chart own = seriesOf(results, readMeasure("volume", IfSeveral::first), scenario);
  CHECK(own.xLabel == "time");
  CHECK(own.yLabel == "volume [length³]");
  CHECK(own.lines.at(0).points.at(1).x == 1.5);
  CHECK(own.lines.at(0).points.at(1).y == 2);
  scenario.units = {"µm", "min", 3, 4};
  const Chart shown = seriesOf(results, readMeasure("volume", IfSeveral::first), scenario);
  CHECK(shown.xLabel == "time [min]");
  CHECK(shown.yLabel == "volume [µm³]");
  CHECK(shown.lines.at(0).points.at(1).x == 6);
  CHECK(shown.lines.at(0).points.at(1).y == 54);
  const Chart pressure = seriesOf(results, readMeasure("mean_pressure"), scenario);
  CHECK(pressure.yLabel == "mean pressure [force/length²]");
  CHECK(pressure.lines.at(0).points.at(1).y == 5);
}

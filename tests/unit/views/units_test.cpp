// Charts in the units of the scenario.
#include "catch.h"
#include "views/measure_bounds.h"
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

TEST_CASE("the bounds of measures are those that their meaning says") {
  std::size_t shares = 0;
  const auto check = [&](const auto& table) {
    for (const auto& row : table) {
      CAPTURE(row.name);
      const auto measure = readMeasure(row.name, IfSeveral::first);
      if (measure.row != row.name) continue;
      const AxisBounds bounds = boundsOf(measure);
      CHECK(bounds.low < bounds.high);
      const bool isShare = std::string(row.meaning).starts_with("Share ");
      shares += isShare;
      if (isShare) CHECK((bounds.low == 0 && bounds.high == 1));
      if (row.isWhole) CHECK((bounds.low == 0 || bounds.low == 1));
      CHECK_FALSE(shortMeaningOf(measure).empty());
    }
  };
  check(measures<Observation>()), check(measures<CellContext>()), check(measures<Touch>());
  CHECK(shares > 9);
  CHECK(boundsOf(readMeasure("clone_radius"), 27).low == 0);
  CHECK(boundsOf(readMeasure("axis_to_x")).high == 90);
  CHECK(boundsOf(readMeasure("count of A*")).low == 0);
  CHECK(boundsOf(readMeasure("momentum_x")).low < -1e300);
  CHECK(boundsOf(readMeasure("clone_contact - sister_contact")).low < -1e300);
}

// Where words and numbers of a chart lie.
#include "charts/chart.h"

#include "catch.h"

using namespace morula;

TEST_CASE("No number beside the vertical axis lies on the axis' title") {
  Chart chart;
  chart.title = "title", chart.xLabel = "x";
  chart.xScale = Chart::Scale::decades;
  for (const double low : {1e-12, 1e-6, 2e-5, 1.1e-4, 0.3}) {
    CAPTURE(low);
    chart.yLabel = "";
    chart.lines = {{"line", {0x0b, 0x3c, 0x6f}, {{1, low}, {10, 90 * low}}, false, {}}};
    const Image without = drawChart(chart);
    chart.yLabel = "a long title that stands upright beside all the numbers of the axis from top to bottom";
    const Image with = drawChart(chart);
    std::size_t title = 0, covered = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
      if (with.pixels[i] == without.pixels[i]) continue;
      ++title;
      covered += without.pixels[i] != paper;
    }
    CHECK(title > 100);
    CHECK(covered == 0);
  }
}

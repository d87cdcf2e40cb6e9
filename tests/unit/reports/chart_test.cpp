// What a chart shows, and where its words and numbers lie.
#include "charts/chart.h"

#include <algorithm>

#include "catch.h"
#include "pictures.h"

using namespace morula;

TEST_CASE("No number beside the vertical axis lies on the axis' title") {
  Chart chart;
  chart.title = "title", chart.xLabel = "x";
  chart.xScale = Axis::Scale::decades;
  for (const double low : {1e-12, 1e-6, 2e-5, 1.1e-4, 0.3}) {
    CAPTURE(low);
    chart.yLabel = "";
    chart.lines = {{"line", {0x0b, 0x3c, 0x6f}, {{1, low}, {10, 90 * low}}, false, {}}};
    const Image without = drawChart(chart).pixels();
    chart.yLabel = "a long title that stands upright beside all the numbers of the axis from top to bottom";
    const Image with = drawChart(chart).pixels();
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

TEST_CASE("A chart shows its lines, and draws nothing of nothing") {
  const Colour red{200, 0, 0}, blue{0, 0, 200};
  Chart chart;
  chart.title = "title";
  chart.lines = {{"one", red, {{8, 10}, {64, 100}}}, {"two", blue, {{8, 20}, {64, 30}}, true}};
  CHECK(countPixels(drawChart(chart), red) > 500);
  CHECK(countPixels(drawChart(chart), blue) > 200);
  CHECK(countPixels(drawChart(chart), blue) < countPixels(drawChart(chart), red));
  chart.lines = {{"one", red, {{8, 10}}}};  // a single point
  CHECK(countPixels(drawChart(chart), red) > 10);
  chart.lines.clear();
  CHECK(countPixels(drawChart(chart), red) == 0);
}

TEST_CASE("Labels of points lie beside their line and not on it, whichever way it goes") {
  const Colour red{200, 0, 0};
  for (const bool rising : {true, false}) {
    CAPTURE(rising);
    Chart chart;
    chart.lines = {{"line", red, {{8, 10}, {32, 100}, {128, 1000}}}};
    if (!rising) std::swap(chart.lines[0].points[0].y, chart.lines[0].points[2].y);
    const Image without = drawChart(chart).pixels();
    chart.lines[0].pointLabels = {"1/128", "1/256", "1/512"};
    const Image with = drawChart(chart).pixels();
    std::size_t labels = 0, covered = 0;
    for (std::size_t i = 0; i < with.pixels.size(); ++i) {
      if (with.pixels[i] == without.pixels[i]) continue;
      ++labels;
      covered += without.pixels[i].g < 100;  // of the line or a point
    }
    CHECK(labels > 200);
    CHECK(covered == 0);
  }
}

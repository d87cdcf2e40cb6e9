// The contents of a chart, and the places of its words and numbers.
#include "charts/chart.h"

#include "catch.h"
#include "pictures.h"

using namespace morula;

namespace {

/// Returns the pixels of `below` at which `above` differs.
Image coveredBy(const Image& above, const Image& below) {
  Image covered;
  for (std::size_t i = 0; i < below.pixels.size(); ++i)
    if (above.pixels[i] != below.pixels[i]) covered.pixels.push_back(below.pixels[i]);
  return covered;
}

}  // namespace

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
    const Image title = coveredBy(with, without);
    CHECK(title.pixels.size() > 100);
    CHECK(countPixels(title, isInk) == 0);
  }
}

TEST_CASE("A chart shows its lines, and draws nothing of nothing") {
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
  for (const bool rising : {true, false}) {
    CAPTURE(rising);
    Chart chart;
    chart.lines = {{"line", red, {{8, 10}, {32, 100}, {128, 1000}}}};
    if (!rising) std::swap(chart.lines[0].points[0].y, chart.lines[0].points[2].y);
    const Image without = drawChart(chart).pixels();
    chart.lines[0].pointLabels = {"1/128", "1/256", "1/512"};
    const Image with = drawChart(chart).pixels();
    const Image labels = coveredBy(with, without);
    CHECK(labels.pixels.size() > 200);
    CHECK(countPixels(labels, [](Colour c) { return c.g < 100; }) == 0);  // no pixels of the line or a point
  }
}

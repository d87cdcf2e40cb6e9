// Marks that readers tell apart without colours.
#include <set>

#include "catch.h"
#include "charts/chart.h"
#include "drawing/annotations.h"
#include "pictures.h"

namespace morula {

namespace {

constexpr Colour dark{0x20, 0x20, 0x20};

}  // namespace

TEST_CASE("no two marks look alike, and all are about as large", "[marker]") {
  std::set<std::string> seen;
  for (const Marker marker : {Marker::disc, Marker::square, Marker::triangle, Marker::diamond, Marker::hanging,
                              Marker::plus, Marker::ring, Marker::cross}) {
    Drawing drawing(30, 30);
    drawMarker(drawing, {15, 15}, 8, dark, marker);
    seen.insert(drawing.file(PictureFormat::png));
    const int inked = countPixels(drawing, dark);
    CHECK(inked > 0.4 * 201);  // share of the disc's area
    CHECK(inked < 1.7 * 201);
  }
  CHECK(seen.size() == 8);
  std::set<Marker> series;
  for (std::size_t i = 0; i < 7; ++i) series.insert(seriesMarker(i));
  CHECK(series.size() == 7);
  CHECK(!series.contains(Marker::cross));
}

TEST_CASE("a legend's entries keep their places when others come and go", "[marker]") {
  const auto drawn = [](bool first) {
    Drawing drawing(300, 100);
    annotate(drawing, {"", "", {{red, "one of them", Marker::square, first}, {blue, "the other"}}});
    return drawing.pixels();
  };
  const auto isBlue = [](Colour c) { return c == blue; };
  CHECK(extentOf(drawn(true), isBlue).left == extentOf(drawn(false), isBlue).left);
  CHECK(countPixels(drawn(false), red) == 0);
}

TEST_CASE("two lines of a chart differ in more than their colour", "[marker]") {
  const auto chartOf = [](bool first, bool dots) {
    // The line under test is dark and the chart's first or second; the other line is invisible.
    Chart chart;
    const ChartLine line{"", dark, {{0, 0}, {1, 1}, {2, 0}, {3, 1}}}, other{"", paper, {{0, 0}, {3, 0}}};
    chart.lines = first ? std::vector{line, other} : std::vector{other, line};
    chart.xScale = chart.yScale = Axis::Scale::linear;
    chart.dots = dots;
    return drawChart(chart).pixels();
  };
  for (const bool dots : {true, false}) CHECK_FALSE(chartOf(true, dots) == chartOf(false, dots));
}

}  // namespace morula

// All values are visible, means and intervals stand beside them, and no label covers another.
#include "charts/small_multiples.h"

#include "catch.h"
#include "drawing/palette.h"
#include "pictures.h"

using namespace morula;

namespace {

/// Returns the number of connected runs of columns that have a pixel of the colour.
int groupsAcross(const Drawing& drawing, Colour colour) {
  const Image image = drawing.pixels();
  int groups = 0;
  bool before = false;
  for (int x = 0; x < image.width; ++x) {
    bool any = false;
    for (int y = 0; y < image.height; ++y) any = any || image.at(x, y) == colour;
    groups += any && !before;
    before = any;
  }
  return groups;
}

SmallMultiples chartOf(std::vector<Strip> strips) {
  SmallMultiples chart;
  chart.panels = {{.title = "clone_radius [length]", .strips = std::move(strips), .lines = {}}};
  return chart;
}

}  // namespace

TEST_CASE("Each value of a strip is a point of its own, and equal ones stand below each other") {
  const Strip strip{"one", red, {1, 2, 3, 4, 5}, 3, std::pair{2.5, 3.5}};
  CHECK(groupsAcross(drawSmallMultiples(chartOf({strip})), red) == 5);
  CHECK(groupsAcross(drawSmallMultiples(chartOf({strip, {"two", blue, {3}, 3}})), blue) == 1);
  const Strip equal{"one", red, {1, 1, 1}, 1}, single{"one", red, {1}, 1};
  CHECK(countPixels(drawSmallMultiples(chartOf({equal})), red) >
        countPixels(drawSmallMultiples(chartOf({single})), red) + 10);
  auto without = strip;
  without.interval.reset();
  CHECK(countPixels(drawSmallMultiples(chartOf({strip})), ink) >
        countPixels(drawSmallMultiples(chartOf({without})), ink) + 50);
}

TEST_CASE("Many counts become their median, quartiles and range, few stay points") {
  // Median 3, quartiles 2 and 4, range 0 to 10.
  const std::vector<double> counts{0, 2, 2, 3, 3, 3, 4, 4, 10};
  SmallMultiples chart = chartOf({{"many", red, counts, 3.4}});
  CHECK(groupsAcross(drawSmallMultiples(chart), red) > 1);
  chart.panels[0].counts = true;
  const Image image = drawSmallMultiples(chart).pixels();
  // The line spans the range; the band, several pixels high, spans 2 to 4 of the range and a little more.
  int line = 0, band = 0;
  for (int x = 0; x < image.width; ++x) {
    int high = 0;
    for (int y = 0; y < image.height; ++y) high += image.at(x, y) == red;
    line += high > 0, band += high > 5;
  }
  CHECK(line > 250);
  CHECK(band == Approx(0.2 * line + 20).margin(14));
  chart.panels[0].strips[0].values.resize(maxPoints);
  CHECK(groupsAcross(drawSmallMultiples(chart), red) > 1);
}

TEST_CASE("Strips of one label stand below it together, all words are level, and nothing lies beyond the paper") {
  std::vector<Strip> strips;
  for (int i = 0; i < 15; ++i)
    strips.push_back({"a label that is rather long " + std::to_string(i), red, {double(i)}, double(i)});
  const auto drawing = drawSmallMultiples(chartOf(strips));
  CHECK(groupsAcross(drawing, red) == 15);
  CHECK_FALSE(touchesEdges(drawing.pixels()));
  auto together = strips;
  for (Strip& strip : together) strip.label = "one";
  CHECK(drawSmallMultiples(chartOf(together)).height() < drawing.height() - 14 * 13);
  CHECK(countPixels(drawSmallMultiples(chartOf({})), red) == 0);
  CHECK(drawSmallMultiples({}).width() > 0);
  CHECK(countPixels(drawSmallMultiples(chartOf({{"equal", red, {0, 0}, 0, std::pair{0., 0.}}})), red) > 10);
  // A study with many measures fits on a page.
  SmallMultiples study = chartOf(strips);
  study.panels.assign(8, study.panels[0]);
  const auto page = drawSmallMultiples(study);
  CHECK(page.height() < 1.6 * page.width());
}

TEST_CASE("Panels have scales of their own, and lines over time have theirs") {
  SmallMultiples chart = chartOf({{"small", red, {1e-6, 2e-6}, 1.5e-6}});
  chart.panels.push_back({.title = "large", .strips = {{"large", blue, {1e6, 2e6}, 1.5e6}}, .lines = {}});
  chart.panels.push_back({.title = "over time",
                          .strips = {},
                          .lines = {{Colour{0, 150, 0}, {{0, 1}, {5, 3}}, {{0.5, 1.5}, {2, 4}}}},
                          .xLabel = "time"});
  const auto drawing = drawSmallMultiples(chart);
  CHECK(drawing.width() % chart.panelWidth == 0);
  CHECK(groupsAcross(drawing, red) == 2);
  CHECK(groupsAcross(drawing, blue) == 2);
  CHECK(countPixels(drawing, {0, 150, 0}) > 200);
}

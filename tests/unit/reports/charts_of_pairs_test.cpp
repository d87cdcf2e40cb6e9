// Roses and matrices: counts, and places of colours.
#include "charts/charts_of_pairs.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "catch.h"
#include "charts/chart.h"
#include "drawing/palette.h"
#include "pictures.h"

using namespace morula;

TEST_CASE("directions are counted in the sector that they lie in, whatever turn they are given in") {
  // Sectors span 90°, the first from -45° to 45°.
  CHECK(countSectors({0, 44, -44, 360, -720, 46, 90, 134, 136, 180, 224, 226, -90}, 4) == std::vector<int>{5, 3, 3, 2});
  const auto counts = countSectors(std::vector<double>(100, 33), 360);
  CHECK(std::accumulate(counts.begin(), counts.end(), 0) == 100);
  CHECK(counts[33] == 100);
}

TEST_CASE("a rose's wedges lie where they point, with areas as their counts") {
  RosePicture picture;
  picture.sectors = 8, picture.width = picture.height = 600;
  std::vector<double> degrees(8, 0.0);
  degrees.insert(degrees.end(), 2, 90.0);
  picture.roses = {{"rose", "x", "y", degrees}};
  const Image image = drawRoses(picture).pixels();
  // Both wedges begin in the middle: measures how far ink reaches to the right and up along the middles of the wedges.
  int most = 0, first = 0, last = 0;  // the rows in which ink reaches farthest to the right
  for (int y = 0; y < 600; ++y)
    for (int x = 300; x < 600; ++x) {
      if (!(image.at(x, y) == seriesColour(0)) || x < most) continue;
      if (x > most) first = y;
      most = x, last = y;
    }
  const int middle = (first + last) / 2;
  const auto reach = [&](int dx, int dy) {
    int steps = 8;
    while (image.at(300 + steps * dx, middle + steps * dy) == seriesColour(0)) ++steps;
    return steps;
  };
  CHECK(double(reach(1, 0)) / reach(0, -1) == Approx(2).epsilon(0.03));  // √(8/2)
  CHECK(!(image.at(300 - 20, middle) == seriesColour(0)));
  CHECK(!(image.at(300, middle + 20) == seriesColour(0)));
  picture.roses[0].degrees.push_back(NAN);
  CHECK_THROWS_AS(drawRoses(picture), InputError);
  picture.roses[0].degrees.pop_back();
  picture.sectors = 3;
  CHECK_THROWS_AS(drawRoses(picture), InputError);
}

TEST_CASE("a matrix shows each value once, from the scale's one end to the other") {
  MatrixPicture picture;
  picture.names = {"A", "B", "C"};
  picture.values.assign(9, std::nullopt);
  picture.values[1] = picture.values[3] = 1;
  picture.values[5] = picture.values[7] = 4;
  picture.quantity = "area";
  const Image image = drawMatrix(picture).pixels();
  const int lows = countPixels(image, scaleColour(0)), highs = countPixels(image, scaleColour(1));
  CHECK(lows > 2000);
  CHECK(highs > 2000);
  CHECK(std::abs(double(lows) / double(highs) - 1) < 0.02);
  picture.values.pop_back();
  CHECK_THROWS_AS(drawMatrix(picture), InputError);
  CHECK(drawMatrix({}).width() > 0);
}

TEST_CASE("a linear chart has its points where its numbers say") {
  Chart chart;
  chart.xScale = chart.yScale = Axis::Scale::linear;
  chart.lines = {{"", {0xff, 0, 0}, {{0, -1}, {1, 0}, {2, 1}}}};
  const Image image = drawChart(chart).pixels();
  // Three dots on a straight line: the middle one halfway between the others.
  double low = 1e9, high = -1, sum = 0;
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (image.at(x, y) == Colour{0xff, 0, 0})
        low = std::min(low, double(x)), high = std::max(high, double(x)), sum += x, ++count;
  REQUIRE(count > 100);
  CHECK(sum / count == Approx(0.5 * (low + high)).margin(1.5));
  chart.lines[0].points = {{3, 5}};  // a single point, so all values are equal
  CHECK(drawChart(chart).width() == chart.width);
}

#include "organism/instruments.h"

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "drawing/annotations.h"
#include "drawing/palette.h"
#include "organism/camera.h"
#include "pictures.h"

namespace morula {

TEST_CASE("round numbers are 1, 2 and 5 times powers of ten", "[instruments]") {
  const std::pair<double, double> cases[] = {{1, 1},   {1.99, 1}, {2, 2},       {4.9, 2},  {5, 5},
                                             {9.9, 5}, {10, 10},  {0.03, 0.02}, {777, 500}};
  for (const auto& [most, round] : cases) CHECK(roundBelow(most) == Approx(round).epsilon(1e-12));
}

namespace {

/// Returns the longest run [pixel], in rows from `top` on, of pixels nearer to the rows' darkest pixel than to paper.
/// Ends are softened, and the run ends where half of the ink is.
int longestRun(const Image& image, int top, int bottom) {
  int darkest = brightness(paper), longest = 0;
  for (int y = top; y < bottom; ++y)
    for (int x = 0; x < image.width; ++x) darkest = std::min(darkest, brightness(image.at(x, y)));
  for (int y = top; y < bottom; ++y)
    for (int x = 0, run = 0; x < image.width; ++x) {
      run = 2 * brightness(image.at(x, y)) < darkest + brightness(paper) ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  return longest;
}

}  // namespace

TEST_CASE("the scale bar is as long as a thing of its length in the picture, to a pixel", "[instruments]") {
  for (const double distance : {10.0, 7.3, 23.0}) {
    OrganismPicture p = picture({}, 500);
    p.camera.framing->distance = distance;
    p.instruments.scaleBar = true;
    const int band = instrumentsHeight(p.instruments, 500, textSizeFor(500, 500));
    const Image bare = drawOrganism(p);
    const int bar = longestRun(bare, 500 - band, 500);
    // The expected length follows from the camera: 0.19 is the tangent of half the smaller side's angle.
    const double pixelsPerLength = 0.5 * (500 - band) / (0.19 * distance);
    const double length = roundBelow(100 / pixelsPerLength);
    CHECK(std::abs(bar - length * pixelsPerLength) <= 1);
    // A line of this length at the middle's depth must be as long as the bar.
    p.lines = {{{-0.5 * length, 0, 0}, {0.5 * length, 0, 0}, red}};
    const int line = longestRun(drawOrganism(p), 0, 500 - band);
    CAPTURE(distance, length, bar, line);
    CHECK(std::abs(bar - line) <= 1);
  }
}

TEST_CASE("instruments stand below the scene and leave it as it is", "[instruments]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)}, 400);
  p.instruments = {.axes = true,
                   .scaleBar = true,
                   .colourBar = ColourBar{"volume [length³]", 1, 2},
                   .arrowKey = ArrowKey{0.1, "[force]", ink}};
  const int band = instrumentsHeight(p.instruments, 400, textSizeFor(400, 400));
  REQUIRE(band > 0);
  const Image image = drawOrganism(p);
  // The scene's middle is the middle of the area above the band.
  CHECK(isReddish(image.at(200, (400 - band) / 2)));
  OrganismPicture scene = picture({ball("", {0, 0, 0}, 1, red)}, 400);
  scene.height = 400 - band;
  REQUIRE(part(image, 0, 0, 400, 400 - band) == drawOrganism(scene));
  // Narrow pictures need more rows of instruments, and none lies beyond an edge.
  CHECK(instrumentsHeight(p.instruments, 150, 10) > instrumentsHeight(p.instruments, 1500, 10));
  for (const int width : {150, 400, 900}) {
    OrganismPicture narrow = p;
    narrow.width = width, narrow.height = 700;
    REQUIRE_FALSE(touchesEdges(drawOrganism(narrow)));
  }
}

TEST_CASE("a colour bar begins and ends with the colours of its ends", "[instruments]") {
  Drawing drawing(300, 80);
  drawColourBar(drawing, {"q", 0, 1}, {20, 10}, 250, 14);
  const Image image = drawing.pixels();
  const int y = 10 + 21 + 6;
  const auto [first, last, top, bottom] = extentOf(part(image, 0, y, 300, 1), isInk);
  CHECK(first == 20);
  CHECK(last == 269);
  CHECK(image.at(first, y) == scaleColour(0));
  CHECK(image.at(last, y) == scaleColour(1));
  for (int x = first; x < last; ++x) {  // lightness rises all along
    const auto light = [&](int at) {
      const Colour c = image.at(at, y);
      return 0.2126 * linearLight(c.r) + 0.7152 * linearLight(c.g) + 0.0722 * linearLight(c.b);
    };
    REQUIRE(light(x + 1) >= light(x) - 0.003);
  }
}

TEST_CASE("axes show where x, y and z point", "[instruments]") {
  OrganismPicture p = picture({}, 900);
  p.camera = parseView("front");
  p.camera.framing = Framing{{0, 0, 0}, 10};
  p.instruments.axes = true;
  const int band = instrumentsHeight(p.instruments, 300, textSizeFor(900, 900));
  const Image image = drawOrganism(p);
  const double size = textSizeFor(900, 900);
  const int x = int(1.5 * size + 2.5 * size), y = int(900 - band + 2.6 * size);
  const auto near = [](Colour a, Colour b) {
    return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 60;
  };
  CHECK(near(image.at(x + int(0.8 * size), y), seriesColour(1)));  // x to the right
  CHECK(near(image.at(x, y - int(0.8 * size)), seriesColour(0)));  // z upwards
}

}  // namespace morula

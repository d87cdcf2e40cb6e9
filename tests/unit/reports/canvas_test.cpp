#include "drawing/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "catch.h"
#include "drawing/text.h"

namespace morula {
namespace {

/// How much ink a picture holds, in pixels of full black on white.
double ink(const Image& image) {
  double sum = 0;
  for (const Colour& c : image.pixels) sum += (255 - c.r) / 255.0;
  return sum;
}

constexpr Colour white{255, 255, 255}, black{0, 0, 0};

}  // namespace

TEST_CASE("a stroke holds as much ink as its area, wherever it lies between the pixels", "[canvas]") {
  for (const double width : {0.4, 1.0, 3.0, 7.5})
    for (const double shift : {0.0, 0.25, 0.5, 0.9}) {
      Image image(100, 40, white);
      drawStroke(image, {{20, 20 + shift}, {80, 20 + shift}}, width, black);
      // Ends are round; thin ones add up to a pixel.
      REQUIRE(ink(image) == Approx(60 * width).margin(0.8 * width * width + 0.12 * 60 * width + 1));
    }
}

TEST_CASE("a disc holds as much ink as its area", "[canvas]") {
  for (const double radius : {2.0, 5.0, 9.3}) {
    Image image(40, 40, white);
    drawDisc(image, {20.3, 19.8}, radius, black);
    REQUIRE(ink(image) == Approx(3.14159265 * radius * radius).epsilon(0.02));
  }
}

TEST_CASE("joints are not darker than the line", "[canvas]") {
  Image image(60, 60, white);
  drawStroke(image, {{10, 30}, {30, 30}, {30, 30}, {50, 30}}, 0.5, black);
  for (int x = 20; x < 40; ++x) REQUIRE(image.at(x, 29) == image.at(20, 29));
}

TEST_CASE("drawing beyond the edges is cut off", "[canvas]") {
  Image image(20, 20, white);
  drawStroke(image, {{-50, 10}, {70, 10}}, 2, black);
  REQUIRE(ink(image) == Approx(40).epsilon(0.01));
  drawDisc(image, {-100, -100}, 5, black);
  drawStroke(image, {}, 2, black);
  REQUIRE(ink(image) == Approx(40).epsilon(0.01));
}

TEST_CASE("text runs as far as it says and stays on its line", "[text]") {
  if (findFont(false).empty()) return;  // pictures without words are fine
  const TextStyle style{.size = 20, .colour = black};
  const double width = textWidth("Morula", style);
  REQUIRE(width > 40);
  REQUIRE(width < 100);
  REQUIRE(textWidth("MorulaMorula", style) == Approx(2 * width).epsilon(0.02));
  Image image(200, 60, white);
  drawText(image, 50, 40, "Morula", style);
  REQUIRE(ink(image) > 100);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 200; ++x)
      if (x < 49 || x > 51 + width || y < 40 - 20 || y > 45) REQUIRE(image.at(x, y) == white);
}

TEST_CASE("anchors move text by its width, and upward text is the same turned", "[text]") {
  if (findFont(false).empty()) return;
  const auto inkBox = [](const TextStyle& style) {
    Image image(200, 200, white);
    drawText(image, 100, 100, "AVm", style);
    int left = 200, right = 0, top = 200, bottom = 0;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x)
        if (image.at(x, y) != white)
          left = std::min(left, x), right = std::max(right, x), top = std::min(top, y),
          bottom = std::max(bottom, y);
    return std::array{left, right, top, bottom};
  };
  const TextStyle style{.size = 24, .colour = black};
  const auto fromLeft = inkBox(style);
  REQUIRE(fromLeft[0] >= 99);
  REQUIRE(inkBox({.size = 24, .colour = black, .anchor = Anchor::right})[1] <= 100);
  const auto centred = inkBox({.size = 24, .colour = black, .anchor = Anchor::centre});
  REQUIRE(std::abs(centred[0] + centred[1] - 200) <= 4);
  const auto upward = inkBox({.size = 24, .colour = black, .upward = true});
  REQUIRE(upward[3] <= 100);
  REQUIRE(std::abs((upward[3] - upward[2]) - (fromLeft[1] - fromLeft[0])) <= 2);
  REQUIRE(upward[1] <= 101);
}

TEST_CASE("long text is shortened, and broken UTF-8 does no harm", "[text]") {
  if (findFont(false).empty()) return;
  const TextStyle style{.size = 12};
  const std::string text = "Zellen wachsen über sich hinaus";
  REQUIRE(shortened(text, style, 1000) == text);
  for (double width = 0; width < textWidth(text, style); width += 3) {
    const std::string shorter = shortened(text, style, width);
    REQUIRE(textWidth(shorter, style) <= width);
    REQUIRE((shorter.empty() || shorter.ends_with("…")));
  }
  Image image(100, 30, white);
  REQUIRE_NOTHROW(drawText(image, 5, 20, "\xff\xc3\x28\xe2\x82", style));
  REQUIRE(textWidth("\xff", style) == textWidth("\uFFFD", style));
}

}  // namespace morula

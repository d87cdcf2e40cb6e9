// Translucent cells and cells that are cut open.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/error.h"
#include "catch.h"
#include "drawing/png_file.h"
#include "pictures.h"

namespace morula {

namespace {

/// Returns a solid colour behind two veils of the given opacities, composed in linear light.
Colour seenThrough(double a, Colour front, double b, Colour middle, Colour back) {
  const auto channel = [&](std::uint8_t Colour::*c) {
    const double behind = b * linearLight(middle.*c) + (1 - b) * linearLight(back.*c);
    return channelOf(a * linearLight(front.*c) + (1 - a) * behind);
  };
  return {channel(&Colour::r), channel(&Colour::g), channel(&Colour::b)};
}

}  // namespace

TEST_CASE("what lies behind a translucent cell shines through", "[organism]") {
  CellShape veil = ball("A", {0, 0, 0.8}, 0.6, blue);
  const CellShape back = ball("B", {0, 0, -0.8}, 1, red);
  int lastRed = centre(drawOrganism(picture({back}))).r;
  for (const double opacity : {0.25, 0.5, 0.75}) {
    veil.opacity = opacity;
    const Colour mixed = centre(drawOrganism(picture({veil, back})));
    REQUIRE(mixed.r < lastRed);
    REQUIRE(mixed.r > red.r / 3);
    lastRed = mixed.r;
  }
  veil.opacity = 0;
  REQUIRE(drawOrganism(picture({back})) == drawOrganism(picture({veil, back})));
}

TEST_CASE("translucent cells before each other and before a solid one are composed in linear light", "[organism]") {
  CellShape front = ball("A", {0, 0, 2}, 0.5, blue), middle = ball("B", {0, 0, 0.6}, 0.5, {40, 200, 40});
  const CellShape back = ball("C", {0, 0, -1}, 0.5, red);
  std::vector<Colour> alone;
  for (const CellShape& cell : {front, middle, back}) alone.push_back(centre(drawOrganism(picture({cell}))));
  front.opacity = 0.3;
  middle.opacity = 0.6;
  const Colour together = centre(drawOrganism(picture({back, front, middle})));
  REQUIRE(apart(together, seenThrough(0.3, alone[0], 0.6, alone[1], alone[2])) <= 2);
}

TEST_CASE("a cell within two translucent ones has the colour that three veils give, to 2 of 255", "[organism]") {
  CellShape outer = ball("A", {0, 0, 0}, 1.6, {230, 230, 60}), inner = ball("B", {0, 0, 0}, 1.0, {40, 200, 40});
  const CellShape core = ball("C", {0, 0, 0}, 0.5, blue);
  std::vector<Colour> alone;
  for (const CellShape& cell : {outer, inner, core}) alone.push_back(centre(drawOrganism(picture({cell}))));
  for (const auto& [a, b] : {std::pair{0.3, 0.6}, {0.5, 0.5}, {0.15, 0.85}}) {
    outer.opacity = a, inner.opacity = b;
    const Colour expected = seenThrough(a, alone[0], b, alone[1], alone[2]);
    for (const auto& cells : {std::vector{outer, inner, core}, {core, outer, inner}, {inner, core, outer}})
      CHECK(apart(centre(drawOrganism(picture(cells))), expected) <= 2);
  }
}

TEST_CASE("however many translucent cells lie one behind the other, all count", "[organism]") {
  std::vector<CellShape> cells;
  for (int i = 0; i < 40; ++i) {
    cells.push_back(ball("A", {0, 0, -0.1 * i}, 0.4, {40, 200, 40}));
    cells.back().opacity = 0.02;
  }
  const Colour veils = centre(drawOrganism(picture(cells)));
  const CellShape back = ball("B", {0, 0, -6}, 0.5, red);
  cells.push_back(back);
  const Colour all = centre(drawOrganism(picture(cells))), alone = centre(drawOrganism(picture({back})));
  const double through = std::pow(0.98, 40);  // share of the paper's light, or of the last cell's
  const double expected = linearLight(veils.r) + through * (linearLight(alone.r) - linearLight(paper.r));
  CHECK(std::abs(all.r - int(channelOf(expected))) <= 2);
}

TEST_CASE("a transparent picture has the disc's area as its opacity, to half a per cent", "[organism]") {
  for (const int samples : {2, 4}) {
    OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)}, 400);
    p.transparent = true;
    p.samples = samples;
    const Image image = drawOrganism(p);
    REQUIRE(image.opacity.size() == image.pixels.size());
    double area = 0;
    for (const std::uint8_t a : image.opacity) area += a / 255.0;
    const double radius = 200 / 0.19 / std::sqrt(99.0);  // as in organism_test.cpp
    CHECK(area == Approx(3.14159265358979 * radius * radius).epsilon(0.005));
    CHECK(image.opacity[0] == 0);
    CHECK(image.opacity[200 * 400 + 200] == 255);
    // Opaque pixels are equal in the picture on paper.
    p.transparent = false;
    CHECK(std::abs(image.at(200, 200).r - drawOrganism(p).at(200, 200).r) <= 1);
  }
}

TEST_CASE("a translucent cell on no ground is as opaque as it is said to be", "[organism]") {
  OrganismPicture p = picture({ball("", {0, 0, 0}, 1, red)});
  p.cells[0].opacity = 0.4;
  p.transparent = true;
  const Image image = drawOrganism(p);
  CHECK(std::abs(image.opacity[60 * 120 + 60] - 102) <= 1);
  p.cells[0].opacity = 1;
  const Colour solid = centre(drawOrganism(p));
  CHECK(std::abs(centre(image).r - solid.r) <= 2);
  CHECK(pngFile(image).size() > 100);
}

TEST_CASE("what lies beyond the clip plane is cut away, and the cut shows the cell's colour", "[organism]") {
  OrganismPicture p = picture({ball("A", {0, 0, 0}, 1, red), ball("B", {0, 0, -2.5}, 1.2, blue)});
  p.clip = ClipPlane{{1, 0, 0}, 0};
  const Image half = drawOrganism(p);
  CHECK(isReddish(half.at(60 - 12, 60)));
  CHECK(half.at(60 + 12, 60) == paper);
  p.clip = ClipPlane{{0, 0, 2}, 0};  // cuts the half before the picture's plane away, so that the cut is seen
  const Image open = drawOrganism(p);
  CHECK(isReddish(centre(open)));
  // A cut is flat, so its light is uniform except for shadows at its edge.
  CHECK(std::abs(brightness(open.at(60 - 8, 60)) - brightness(open.at(60 + 8, 60))) <= 3);
  CHECK(std::abs(brightness(open.at(60, 60 - 8)) - brightness(open.at(60, 60 + 8))) <= 3);
  p.clip = ClipPlane{{0, 0, 1}, -1.001};  // cuts the first cell away
  CHECK(isBluish(centre(drawOrganism(p))));
  p.clip = ClipPlane{{0, 0, 1}, 10};  // nothing is cut
  const Image whole = drawOrganism(p);
  p.clip.reset();
  CHECK(whole == drawOrganism(p));
  p.lines = {{{-0.5, 0, 1.5}, {0.5, 0, 1.5}, {0, 0, 0}}};
  p.clip = ClipPlane{{0, 0, 1}, 1.4};
  CHECK(drawOrganism(p) == whole);
  p.clip = ClipPlane{{0, 0, 0}, 1};
  CHECK_THROWS_AS(drawOrganism(p), InputError);
}

TEST_CASE("a solid cell hides the translucent ones behind it", "[organism]") {
  const CellShape front = ball("A", {0, 0, 0.5}, 1, red);
  CellShape hidden = ball("B", {0, 0, -1.6}, 1, blue);
  hidden.opacity = 0.5;
  REQUIRE(drawOrganism(picture({front, hidden})) == drawOrganism(picture({front})));
}

TEST_CASE("the order of translucent cells does not matter, even where they cut through each other", "[organism]") {
  std::vector<CellShape> cells{ball("A", {-0.3, 0, 0.1}, 0.8, red), ball("B", {0.3, 0, 0}, 0.8, blue),
                               ball("C", {0, 0.3, -0.4}, 0.8, {40, 200, 40})};
  for (CellShape& cell : cells) cell.opacity = 0.4;
  const Image first = drawOrganism(picture(cells));
  std::rotate(cells.begin(), cells.begin() + 1, cells.end());
  REQUIRE(drawOrganism(picture(cells)) == first);
  std::swap(cells[0], cells[1]);
  REQUIRE(drawOrganism(picture(cells)) == first);
}

}  // namespace morula

// Organisms side by side: what their distance looks like, and that every tile is whole.
#include "comparison/comparison.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "catch.h"
#include "drawing/palette.h"
#include "pictures.h"

namespace morula {

TEST_CASE("a contact sheet shows every image whole", "[comparison]") {
  std::vector<Image> images;
  for (int i = 0; i < 7; ++i) images.emplace_back(10 + i, 8, Colour{std::uint8_t(10 * i + 10), 0, 0});
  const Image sheet = contactSheet(images, 3, 2).pixels();
  REQUIRE(sheet.width == 3 * (16 + 2) + 2);
  REQUIRE(sheet.height == 3 * (8 + 2) + 2);
  for (int i = 0; i < 7; ++i) {
    const Colour colour{std::uint8_t(10 * i + 10), 0, 0};
    REQUIRE(std::count(sheet.pixels.begin(), sheet.pixels.end(), colour) == (10 + i) * 8);
  }
  REQUIRE(contactSheet({images[0]}).width() == 10 + 16);
  REQUIRE_THROWS_AS(contactSheet({}), InputError);
}

TEST_CASE("the third picture shows where the surfaces are apart, and says how far", "[comparison]") {
  OrganismPicture one = picture({ball("A", {-1, 0, 0}, 0.5, red), ball("B", {1, 0, 0}, 0.5, red)}, 200);
  OrganismPicture other = picture({ball("A", {-1, 0, 0}, 0.5, blue), ball("B", {1, 0, 0}, 0.6, blue)}, 200);
  one.title = other.title = "a title", one.caption = other.caption = "and words";  // as much as the third has
  const Image image = drawComparison(one, other, 2).pixels();
  REQUIRE(image.width == 3 * (200 + 8) + 8);
  // The scene's middle row.
  const Instruments bar{.axes = false, .scaleBar = false, .colourBar = ColourBar{}, .arrowKey = {}};
  const Bands bands = bandsFor({one.title, one.caption, {}}, 200, 200);
  const int row = 8 + (200 + bands.top - instrumentsHeight(bar, 200, textSizeFor(200, 200))) / 2;
  /// In half of a tile's part of it: so many pixels of a kind.
  const auto count = [&](int tile, bool right, auto kind) {
    const auto* begin = &image.at(8 + tile * 208 + 100 * right, row);
    return std::count_if(begin, begin + 100, kind);
  };
  const auto dark = [](Colour c) { return c.g < 0.6 * c.b; };
  const auto yellowish = [](Colour c) { return c.r > 1.5 * c.b; };
  CHECK(count(0, false, isReddish) > 20);
  CHECK(count(0, true, isReddish) > 20);
  CHECK(count(1, true, isBluish) > 20);
  CHECK(count(2, false, dark) > 20);  // the same there
  CHECK(count(2, false, yellowish) == 0);
  CHECK(count(2, true, dark) == 0);
  CHECK(count(2, true, yellowish) > 20);  // 0.1 apart
  other.cells.pop_back();
  CHECK_THROWS_AS(drawComparison(one, other, 2), InputError);
}

TEST_CASE("cells that only one of two organisms has are grey, and counted", "[comparison]") {
  const OrganismPicture before = picture({ball("A", {-1, 0, 0}, 0.5, red), ball("B", {1, 0, 0}, 0.5, red)}, 200);
  OrganismPicture now = picture({ball("B", {1, 0, 0}, 0.6, red), ball("AA", {-1, 0, 0}, 0.5, red)}, 200);
  const ComparisonImages images = compareOrganisms(before, now, 1, {.ofOther = true});
  CHECK(images.unmatched ==
        "Grey, for there is nothing to compare: 1 cell is only in the second picture. 1 cell is only in the "
        "first picture.");
  const auto grey = [](Colour c) {
    return std::abs(c.r - c.g) < 8 && std::abs(c.g - c.b) < 8 && brightness(c) < 3 * 230;
  };
  const auto half = [&](const Image& image, bool right, auto kind) {
    std::ptrdiff_t n = 0;
    for (int y = 60; y < 140; ++y) n += std::count_if(&image.at(100 * right, y), &image.at(100 * right, y) + 100, kind);
    return n;
  };
  CHECK(half(images.distance, false, grey) > 500);
  const auto yellowish = [](Colour c) { return c.r > 1.5 * c.b; };
  CHECK(half(images.distance, true, yellowish) > 500);  // matched by path, not by place in the list
  CHECK(half(images.distance, false, yellowish) == 0);
  CHECK(comparisonSheet(images, {"a note"}).height() > comparisonSheet(images).height());
}

TEST_CASE("centroids are compared by colour and by an arrow", "[comparison]") {
  const OrganismPicture before = picture({ball("A", {-0.8, 0, 0}, 0.5, red), ball("B", {0.8, 0, 0}, 0.7, red)}, 200);
  OrganismPicture now = picture({ball("A", {-0.8, 0, 0}, 0.7, red), ball("B", {0.8, 0.4, 0}, 0.7, red)}, 200);
  const Image map = compareOrganisms(before, now, 1, {.ofOther = true, .ofCentres = true}).distance;
  const auto dark = [](Colour c) { return c.g < 0.6 * c.b; };
  const auto yellowish = [](Colour c) { return c.r > 1.5 * c.b; };
  std::ptrdiff_t left = 0, right = 0;
  for (int y = 0; y < 160; ++y) {
    left += std::count_if(&map.at(0, y), &map.at(0, y) + 100, dark);
    right += std::count_if(&map.at(100, y), &map.at(100, y) + 100, yellowish);
  }
  CHECK(left > 1000);  // another size, the same place
  CHECK(right > 1000);
}

}  // namespace morula

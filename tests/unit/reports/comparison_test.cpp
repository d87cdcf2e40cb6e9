// Organisms side by side: what their distance looks like, and that every tile is whole.
#include "comparison/comparison.h"

#include <algorithm>

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

}  // namespace morula

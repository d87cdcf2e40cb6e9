// Organisms side by side: how distances look, and that every tile is whole.
#include <cstdlib>

#include "base/error.h"
#include "catch.h"
#include "comparison/organism_pair.h"
#include "pictures.h"

namespace morula {

namespace {

// Colours of the scale of distances: its low end, and large distances.
bool isDark(Colour c) { return c.g < 0.6 * c.b; }
bool isYellowish(Colour c) { return c.r > 1.5 * c.b; }

}  // namespace

TEST_CASE("a contact sheet shows every image whole", "[comparison]") {
  std::vector<Image> images;
  for (int i = 0; i < 7; ++i) images.emplace_back(10 + i, 8, Colour{std::uint8_t(10 * i + 10), 0, 0});
  const Image sheet = contactSheet(images, 3, 2).pixels();
  REQUIRE(sheet.width == 3 * (16 + 2) + 2);
  REQUIRE(sheet.height == 3 * (8 + 2) + 2);
  for (int i = 0; i < 7; ++i) {
    const Colour colour{std::uint8_t(10 * i + 10), 0, 0};
    REQUIRE(countPixels(sheet, colour) == (10 + i) * 8);
  }
  REQUIRE(contactSheet({images[0]}).width() == 10 + 16);
  REQUIRE_THROWS_AS(contactSheet({}), InputError);
}

TEST_CASE("the third picture shows where the surfaces are apart, and says how far", "[comparison]") {
  OrganismPicture one = picture({ball("A", {-1, 0, 0}, 0.5, red), ball("B", {1, 0, 0}, 0.5, red)}, 200);
  OrganismPicture other = picture({ball("A", {-1, 0, 0}, 0.5, blue), ball("B", {1, 0, 0}, 0.6, blue)}, 200);
  one.title = other.title = "a title", one.caption = other.caption = "and words";  // as many as the third
  const Image image = drawComparison(one, other, 2).pixels();
  REQUIRE(image.width == 3 * (200 + 8) + 8);
  // The middle row of the scene.
  const Instruments bar{.axes = false, .scaleBar = false, .colourBar = ColourBar{}, .arrowKey = {}};
  const Bands bands = bandsFor({one.title, one.caption, {}}, 200, 200);
  const int row = 8 + (200 + bands.top - instrumentsHeight(bar, 200, textSizeFor(200, 200))) / 2;
  /// Counts pixels of a kind in half of a tile's row.
  const auto count = [&](int tile, bool right, auto kind) {
    return countPixels(part(image, 8 + tile * 208 + 100 * right, row, 100, 1), kind);
  };
  CHECK(count(0, false, isReddish) > 20);
  CHECK(count(0, true, isReddish) > 20);
  CHECK(count(1, true, isBluish) > 20);
  CHECK(count(2, false, isDark) > 20);  // equal surfaces
  CHECK(count(2, false, isYellowish) == 0);
  CHECK(count(2, true, isDark) == 0);
  CHECK(count(2, true, isYellowish) > 20);  // 0.1 apart
}

TEST_CASE("cells that only one of two organisms has are grey, and counted", "[comparison]") {
  const OrganismPicture before = picture({ball("A", {-1, 0, 0}, 0.5, red), ball("B", {1, 0, 0}, 0.5, red)}, 200);
  OrganismPicture now = picture({ball("B", {1, 0, 0}, 0.6, red), ball("AA", {-1, 0, 0}, 0.5, red)}, 200);
  const ComparisonImages images = compareOrganisms(before, now, 1, {.ofOther = true});
  CHECK(images.unmatched ==
        "Grey, because these cells cannot be compared: 1 cell is only in the second picture. 1 cell is only in the "
        "first picture.");
  const auto grey = [](Colour c) {
    return std::abs(c.r - c.g) < 8 && std::abs(c.g - c.b) < 8 && brightness(c) < 3 * 230;
  };
  const Image left = part(images.distance, 0, 60, 100, 80), right = part(images.distance, 100, 60, 100, 80);
  CHECK(countPixels(left, grey) > 500);
  CHECK(countPixels(right, isYellowish) > 500);  // cells are matched by path, not by place in the list
  CHECK(countPixels(left, isYellowish) == 0);
  CHECK(comparisonSheet(images, {"a note"}).height() > comparisonSheet(images).height());
}

TEST_CASE("centroids are compared by colour and by an arrow", "[comparison]") {
  const OrganismPicture before = picture({ball("A", {-0.8, 0, 0}, 0.5, red), ball("B", {0.8, 0, 0}, 0.7, red)}, 200);
  OrganismPicture now = picture({ball("A", {-0.8, 0, 0}, 0.7, red), ball("B", {0.8, 0.4, 0}, 0.7, red)}, 200);
  const Image map = compareOrganisms(before, now, 1, {.ofOther = true, .ofCentres = true}).distance;
  CHECK(countPixels(part(map, 0, 0, 100, 160), isDark) > 1000);  // A has another size at the same place
  CHECK(countPixels(part(map, 100, 0, 100, 160), isYellowish) > 1000);
}

}  // namespace morula

// Many organisms in one picture: one scale for all, words beside each, and what does not fit.
#include "comparison/organism_grid.h"

#include <algorithm>

#include "base/error.h"
#include "catch.h"
#include "pictures.h"

namespace morula {

namespace {

OrganismTile tile(double radius, Colour colour) {
  return {picture({ball("A", {0, 0, 0}, radius, colour)}), false, "1 cell"};
}

OrganismGrid twoByTwo() {
  return {"title",
          "caption",
          {{"one"}, {"two", "lines"}},
          {"early", "late"},
          {tile(1, red), tile(0.5, red), tile(1, blue), {{}, true, "ended"}},
          {{red, "red"}}};
}

/// Pixels of a kind in the rectangle.
std::ptrdiff_t count(const Image& image, int left, int right, bool (*kind)(Colour)) {
  std::ptrdiff_t n = 0;
  for (int y = 0; y < image.height - 60; ++y)  // without the legend
    n += std::count_if(&image.at(left, y), &image.at(left, y) + (right - left), kind);
  return n;
}

}  // namespace

TEST_CASE("organisms of a grid have one scale", "[comparison]") {
  const Image image = drawOrganismGrid(twoByTwo()).pixels();
  const int side = 340, first = image.width - 12 - 2 * side;
  const auto large = count(image, first, first + side, isReddish),
             small = count(image, first + side, first + 2 * side, isReddish);
  REQUIRE(small > 500);
  CHECK(double(large) / double(small) == Approx(4).epsilon(0.1));  // twice the radius; highlights are not red
  CHECK(count(image, first, first + side, isBluish) > 10000);
  CHECK(count(image, first + side, first + 2 * side, isBluish) == 0);  // empty
}

TEST_CASE("a grid that does not fit is refused", "[comparison]") {
  OrganismGrid grid = twoByTwo();
  grid.tiles.pop_back();
  CHECK_THROWS_WITH(drawOrganismGrid(grid), ContainsSubstring("3 pictures do not fill 2 rows of 2"));
  CHECK_THROWS_AS(drawOrganismGrid({}), InputError);
  OrganismGrid many;
  many.columns = {"one"};
  for (std::size_t i = 0; i <= mostGridRows; ++i)
    many.rows.push_back({"row"}), many.tiles.push_back({{}, true, ""});
  CHECK_THROWS_WITH(drawOrganismGrid(many), ContainsSubstring("41 rows"));
  many.rows.pop_back(), many.tiles.pop_back();
  CHECK_NOTHROW(drawOrganismGrid(many));  // nothing in any tile
}

}  // namespace morula

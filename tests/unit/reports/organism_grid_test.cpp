// Many organisms in one picture: one scale for all, words beside each, and grids that do not fit.
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

constexpr int side = 340;  // [pixel] width of a tile

}  // namespace

TEST_CASE("organisms of a grid have one scale", "[comparison]") {
  const auto pages = drawOrganismGrid(twoByTwo());
  REQUIRE(pages.size() == 1);
  const Image image = pages[0].pixels();
  const int first = image.width - 12 - 2 * side, height = image.height - 60;  // without the legend
  const Image left = part(image, first, 0, side, height), right = part(image, first + side, 0, side, height);
  const int large = countPixels(left, isReddish), small = countPixels(right, isReddish);
  REQUIRE(small > 500);
  CHECK(double(large) / double(small) == Approx(4).epsilon(0.1));  // twice the radius; highlights are not red
  CHECK(countPixels(left, isBluish) > 10000);
  CHECK(countPixels(right, isBluish) == 0);  // the tile is empty
}

TEST_CASE("a grid that does not fit is refused", "[comparison]") {
  OrganismGrid grid = twoByTwo();
  grid.tiles.pop_back();
  CHECK_THROWS_WITH(drawOrganismGrid(grid), ContainsSubstring("3 pictures do not fill 2 rows of 2"));
  CHECK_THROWS_AS(drawOrganismGrid({}), InputError);
  OrganismGrid many;
  many.columns = {"one"};
  for (std::size_t i = 0; i <= maxGridRows; ++i) many.rows.push_back({"row"}), many.tiles.push_back({{}, true, ""});
  CHECK_THROWS_WITH(drawOrganismGrid(many), ContainsSubstring("41 rows"));
  many.rows.pop_back(), many.tiles.pop_back();
  CHECK_NOTHROW(drawOrganismGrid(many));  // all tiles are empty
}

TEST_CASE("a grid goes on beside itself, and then on further pages, none of them longer than a sheet of paper",
          "[comparison]") {
  const auto gridOf = [](std::size_t rows, std::size_t columns) {
    OrganismGrid grid;
    grid.title = "title";
    grid.columns.assign(columns, "column");
    for (std::size_t i = 0; i < rows; ++i) grid.rows.push_back({"row " + std::to_string(i)});
    grid.tiles.assign(rows * columns, tile(1, red));
    return grid;
  };
  for (const std::size_t columns : {1, 2, 5, 12})
    for (const std::size_t rows : {1, 12, 24, 40}) {
      CAPTURE(rows, columns);
      OrganismGrid grid = gridOf(rows, columns);
      for (OrganismTile& t : grid.tiles) t.empty = true;  // the test is about places, not looks
      for (const Drawing& page : drawOrganismGrid(grid)) CHECK(page.height() <= 1.45 * std::max(page.width(), 800));
    }
  // Each tile is drawn once, on whichever page: 26 red balls of equal size.
  const OrganismGrid one = gridOf(1, 1), many = gridOf(13, 2);
  const auto reds = [](const std::vector<Drawing>& pages) {
    double n = 0;
    for (const Drawing& page : pages) n += countPixels(page.pixels(), isReddish);
    return n;
  };
  const auto pages = drawOrganismGrid(many);
  REQUIRE(pages.size() > 1);
  const double scale = 180.0 / side;  // many tiles are drawn smaller
  CHECK(reds(pages) == Approx(26 * scale * scale * reds(drawOrganismGrid(one))).epsilon(0.05));
}

TEST_CASE("a picture that is there is shown as it is", "[comparison]") {
  OrganismGrid grid = twoByTwo();
  for (OrganismTile& t : grid.tiles) t = {{}, false, "", Image(40, 40, {1, 2, 3})};
  const Image image = drawOrganismGrid(grid)[0].pixels();
  CHECK(countPixels(image, Colour{1, 2, 3}) == 4 * 40 * 40);
}

}  // namespace morula

#include "organism/labels.h"

#include <cmath>

#include "base/random.h"
#include "catch.h"
#include "pictures.h"

namespace morula {

namespace {

/// Returns a grid of square cells, each `side` pixels wide.
LabelGround chequered(int columns, int rows, int side) {
  LabelGround ground{columns * side, rows * side, {}};
  for (int y = 0; y < ground.height; ++y)
    for (int x = 0; x < ground.width; ++x) ground.owners.push_back(std::uint32_t(y / side * columns + x / side + 1));
  return ground;
}

bool touch(const PlacedLabel& a, const PlacedLabel& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

}  // namespace

TEST_CASE("a label stands in the middle of its cell where there is room", "[labels]") {
  const LabelGround ground = chequered(3, 2, 60);
  std::vector<LabelWish> wishes;
  for (std::uint32_t i = 1; i <= 6; ++i) wishes.push_back({i, "AB", std::nullopt});
  const auto placed = placeLabels(ground, wishes, 12);
  REQUIRE(placed.size() == 6);
  std::vector<int> seen(7);
  for (const PlacedLabel& label : placed) {
    CHECK(!label.leader);
    const int x = int(0.5 * (label.left + label.right)), y = int(0.5 * (label.top + label.bottom));
    ++seen[ground.owners[std::size_t(y) * ground.width + x]];
    CHECK(std::abs(x % 60 - 30) <= 3);
    CHECK(std::abs(y % 60 - 30) <= 3);
  }
  for (int i = 1; i <= 6; ++i) CHECK(seen[i] == 1);
}

TEST_CASE("labels never touch, however crowded cells are, and stay inside", "[labels]") {
  for (const int side : {6, 11, 17, 25}) {
    const LabelGround ground = chequered(12, 12, side);
    std::vector<LabelWish> wishes;
    for (std::uint32_t i = 1; i <= 144; ++i) wishes.push_back({i, i % 3 ? "ABpla" : "E", std::nullopt});
    const auto placed = placeLabels(ground, wishes, 10);
    CAPTURE(side, placed.size());
    CHECK(placed.size() > 3);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      CHECK(placed[i].left >= 0);
      CHECK(placed[i].top >= 0);
      CHECK(placed[i].right <= ground.width);
      CHECK(placed[i].bottom <= ground.height);
      for (std::size_t k = 0; k < i; ++k) REQUIRE(!touch(placed[i], placed[k]));
    }
  }
}

TEST_CASE("a label that has no room on its cell stands beside it with a line to it", "[labels]") {
  LabelGround ground{200, 100, std::vector<std::uint32_t>(200 * 100)};
  const auto fill = [&](int left, int top, std::uint32_t owner) {
    for (int y = top; y < top + 8; ++y)
      for (int x = left; x < left + 8; ++x) ground.owners[std::size_t(y) * 200 + x] = owner;
  };
  fill(100, 50, 1);
  fill(110, 50, 2);
  const auto placed = placeLabels(ground, {{1, "long name", std::nullopt}, {2, "another", std::nullopt}}, 12);
  REQUIRE(placed.size() == 2);
  CHECK(!touch(placed[0], placed[1]));
  REQUIRE(placed[1].leader);
  const Spot to = *placed[1].leader;
  CHECK(ground.owners[std::size_t(to.y) * 200 + std::size_t(to.x)] == 2);
}

TEST_CASE("hidden cells have no label, and the caption says so", "[labels]") {
  OrganismPicture p = picture({ball("A", {0, 0, 0.5}, 1, red), ball("B", {0, 0, -1.6}, 1, blue)}, 300);
  p.title = "t", p.caption = "2 cells";
  p.labels = {{0, "front"}};
  const Image one = drawOrganism(p);
  OrganismPicture bare = p;
  bare.labels.clear();
  const Image none = drawOrganism(bare);
  CHECK(one != none);
  p.labels.push_back({1, "behind"});
  const Image both = drawOrganism(p);
  const Bands bands = bandsFor({p.title, p.caption + ", 2 of them without a label (hidden, or no room)", {}}, 300, 300);
  REQUIRE(part(both, 0, bands.top, 300, 300 - bands.top) == part(one, 0, bands.top, 300, 300 - bands.top));
  CHECK(both != one);        // captions differ
  p.cells[0].opacity = 0.4;  // the hidden cell becomes visible
  CHECK(drawOrganism(p) != both);
}

}  // namespace morula

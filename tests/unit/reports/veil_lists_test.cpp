#include "organism/veil_lists.h"

#include <algorithm>
#include <cmath>

#include "catch.h"

namespace morula {
namespace {

VeilFragment veil(float depth, std::uint32_t owner, double light, double opacity) {
  const auto l = std::uint16_t(std::lround(light / 2 * 65535));
  return {depth, owner, {l, l, l}, std::uint16_t(std::lround(opacity * 65535))};
}

/// The lists of a grid's samples, one after the other.
struct Grid {
  int width;
  std::vector<VeilFragment> fragments;
  std::vector<std::uint32_t> ends;

  explicit Grid(int width, const std::vector<std::vector<VeilFragment>>& lists) : width(width) {
    for (const auto& list : lists) {
      fragments.insert(fragments.end(), list.begin(), list.end());
      ends.push_back(std::uint32_t(fragments.size()));
    }
  }
  VeilRows rows() { return {width, int(ends.size()) / width, fragments.data(), ends.data()}; }
  std::vector<float> seen(int reach = 1, int threads = 1) {
    sortVeils(rows(), threads);
    return composeVeils(rows(), 0, rows().rows, reach, threads);
  }
};

}  // namespace

TEST_CASE("veils before each other let through what those before them do", "[veils]") {
  // Nine equal samples have no outline. The nearest veil is written last.
  const std::vector<VeilFragment> list{veil(0.7f, 3, 0.2, 1.0), veil(0.5f, 2, 0.6, 0.5), veil(0.1f, 1, 1.0, 0.25)};
  Grid grid(3, std::vector(9, list));
  for (const float x : grid.seen()) CHECK(x >= 0);
  const std::vector<float> seen = grid.seen();
  for (int i = 0; i < 9; ++i) {
    CHECK(seen[4 * i] == Approx(0.25 * 1.0 + 0.75 * (0.5 * 0.6 + 0.5 * 0.2)).margin(4e-5));
    CHECK(seen[4 * i + 3] == Approx(1));
  }
}

TEST_CASE("the order in which surfaces are written does not matter, nor the number of threads", "[veils]") {
  const auto chance = [](std::uint64_t i) { return double(i * 2654435761u % 1000) / 1000; };
  std::vector<std::vector<VeilFragment>> lists;
  for (std::uint64_t i = 0; i < 20; ++i) {
    std::vector<VeilFragment> list;
    // Some veils have equal depths, where the owner decides.
    for (std::uint64_t k = 0; k < i % 7; ++k)
      list.push_back(veil(float(std::floor(4 * chance(i * 31 + k)) / 4), std::uint32_t(k % 3 + 1), chance(i + k), 0.3));
    lists.push_back(list);
  }
  const std::vector<float> seen = Grid(5, lists).seen();
  for (auto& list : lists) std::reverse(list.begin(), list.end());
  CHECK(Grid(5, lists).seen() == seen);
  CHECK(Grid(5, lists).seen(1, 2) == seen);
}

TEST_CASE("a sample without veils shows nothing, and its neighbours have an outline there", "[veils]") {
  const std::vector<VeilFragment> one{veil(0.5f, 1, 0.5, 0.2)};
  Grid grid(5, {one, one, one, one, {}});
  const std::vector<float> seen = grid.seen();
  CHECK(seen[3] == Approx(0.2).margin(1e-4));
  CHECK(seen[4 * 2 + 3] == seen[3]);
  CHECK(seen[4 * 3 + 3] > 0.7);  // outlines are dark and nearly opaque
  CHECK(seen[4 * 3] < 0.5 * seen[4 * 3 + 3]);
  CHECK(std::all_of(&seen[16], &seen[16] + 4, [](float x) { return x == 0; }));
}

TEST_CASE("rows composed apart are those composed together", "[veils]") {
  const std::vector<VeilFragment> one{veil(0.5f, 1, 0.5, 0.2)}, two{veil(0.5f, 2, 0.9, 0.4)};
  Grid grid(2, {one, one, one, two, two, two, {}, {}});
  const std::vector<float> all = grid.seen();
  std::vector<float> parts;
  for (int row = 0; row < 4; ++row)
    for (const float x : composeVeils(grid.rows(), row, row + 1, 1, 1)) parts.push_back(x);
  CHECK(parts == all);
}

}  // namespace morula

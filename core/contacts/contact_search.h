#pragma once
// The ways to find pairs of vertices within reach. All find the same pairs, so none changes a bit of the result;
// several exist to be compared (tests/bench/search_bench.cpp prints what each costs).
#include "base/choice.h"

namespace morula {

enum class ContactSearch { grid, aabbTree, spatialHash, bruteForce };
template <>
inline constexpr auto choices<ContactSearch> = std::to_array<Choice<ContactSearch>>({
    {ContactSearch::grid, "grid", "a uniform grid over the bounding box: the fastest for cells of like size"},
    {ContactSearch::aabbTree, "aabb-tree",
     "a tree of boxes per cell, cell against cell [van den Bergen 1997; Nilsson 2008, §4.3.1]"},
    {ContactSearch::spatialHash, "spatial-hash", "the bins of an unbounded grid, hashed [Teschner et al. 2003]"},
    {ContactSearch::bruteForce, "brute-force", "all vertices against all: the oracle"},
});

/// Settings that change the speed of a search, never a bit of the result.
struct SearchSettings {
  ContactSearch method = ContactSearch::grid;
  /// [1] The skin, over the smallest influence radius: a list stays valid until a vertex has moved half of the skin. A
  /// larger skin makes longer lists and fewer searches; 0.3 is the measured optimum. 0: a search at every step, for
  /// measurements.
  double skinShare = 0.3;
};

}  // namespace morula

#pragma once
// Where the cells of a lineage tree stand, before anything is drawn.
#include <array>
#include <cstddef>
#include <vector>

#include "trees/lineage_tree.h"

namespace morula {

/// A cell's place. Leaves stand side by side, in the order of their paths, at x = 0.5, 1.5, …; a mother
/// stands midway between her daughters, or above the only one that is given.
struct TreePlace {
  const LineageNode* node = nullptr;
  double x = 0;                         // [leaf]
  int mother = -1;                      // index of a place; −1: its mother is not given
  std::array<int, 2> daughter{-1, -1};  // A, B; −1: not given
  std::size_t leaves = 1;               // that descend from it, itself included if it is one
  bool isLeaf() const { return daughter[0] < 0 && daughter[1] < 0; }
};

struct TreeLayout {
  std::vector<TreePlace> places;  // by path: a mother before her daughters, the A side before the B side
  std::size_t leaves = 0;
  double begin = 0, end = 0;  // [time] of the first birth and the last end
};

/// Checks the nodes and places them. The nodes must outlive the layout. Throws InputError as drawLineage does.
TreeLayout layoutTree(const std::vector<LineageNode>& nodes);

}  // namespace morula

#pragma once
// One tree of axis-aligned boxes per cell, cell against cell [van den Bergen 1997; Nilsson 2008, §3.6.2, §4.3.1].
//
// All cells of a mesh template share a tree's shape, and only boxes belong to a cell. The template's vertices are
// halved recursively along the longest side of their box, so a leaf is a patch of the surface, and stays one however
// the cell deforms. A tree is built once per template; when cells move, its boxes are refitted from the leaves up.
// There is no broad phase, as the thesis names none: each cell is tested against all others' roots.
#include "contacts/point_table.h"

namespace morula {

/// Nodes stand in depth-first order: a parent before its children, the first child directly after it.
struct TreeNode {
  std::int32_t first, last;  // the vertices below: [first, last) of TreeShape::order
  std::int32_t second;       // the second child, or 0 for a leaf
  std::int32_t leaf;         // number of the leaf, or −1
};

struct TreeShape {
  std::vector<TreeNode> nodes;
  std::vector<std::int32_t> order;  // vertices of the template
  int leaves = 0;
};

/// Makes a tree's shape whose leaves hold at most `leafSize` vertices.
TreeShape makeTreeShape(const std::vector<Point>& vertices, int leafSize);

/// One cell's tree.
struct CellTree {
  std::int32_t meshLevel;             // the mesh whose shape the tree has
  std::int32_t firstBox, firstPoint;  // where the tree's boxes and points begin
};

struct TreeSearch {
  std::vector<TreeShape> shapes;  // [meshLevel]
  std::vector<CellTree> trees;    // [slot]
  std::vector<Box> boxes;         // [cell][node]
  PointTable points;              // [cell][place in the shape's order]

  /// Scratch of one thread: which leaves of other cells are near a leaf.
  struct Scratch {
    std::vector<std::vector<NearQuery::Row>> rows;  // [leaf]
    std::vector<std::pair<std::int32_t, std::int32_t>> open;
  };
  mutable std::vector<Scratch> scratch;
  SearchCounters preparation;
};

void prepare(TreeSearch& tree, const SearchInput& input, int threads);
void searchBlock(const TreeSearch& tree, const SearchInput& input, int block, BlockLists& lists);

}  // namespace morula

#pragma once
// The lineage tree as a picture. Time runs downward; every cell is a vertical line from its birth to its end, with
// daughter A to the left and B to the right.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "drawing/annotations.h"

namespace morula {

struct LineageNode {
  std::string path;  // "" for the egg, then letters A and B
  double born = 0;   // [time]
  double ended = 0;  // [time] the present for living cells
  Fate fate = Fate::alive;
  Colour colour = neutralGrey;
  std::string label;  // name or state; shown at leaves if there are few
};

/// A cell's place. Leaves stand side by side, sorted by path, at x = 0.5, 1.5, …; a mother stands midway between her
/// daughters, or above her only one.
struct TreePlace {
  const LineageNode* node = nullptr;
  double x = 0;                         // [leaf]
  int mother = -1;                      // index of a place; −1: the mother is not in the tree
  std::array<int, 2> daughter{-1, -1};  // A, B; −1: not in the tree
  std::size_t leaves = 1;               // number of leaves below, or 1 for a leaf
  bool isLeaf() const { return daughter[0] < 0 && daughter[1] < 0; }
};

/// The layout of a tree, before drawing.
struct TreeLayout {
  std::vector<TreePlace> places;  // sorted by path: mothers before daughters, A before B
  std::size_t leaves = 0;
  double begin = 0, end = 0;  // [time] of the first birth and the last end
};

/// Returns the layout of the nodes, which must outlive it. Throws InputError as drawLineage does.
TreeLayout layoutTree(const std::vector<LineageNode>& nodes);

/// A deed of an experiment: a ring on a cell's line, or for all cells a dashed line across the tree.
struct TreeMark {
  std::optional<std::string> path;  // of a node; absent: all cells
  double time = 0;                  // [time]
};

struct TreePicture {
  std::vector<LineageNode> nodes;  // in any order; no path twice
  std::vector<TreeMark> marks = {};
  std::string title, caption;      // UTF-8
  std::string timeLabel = "time";  // title of the axis, with the unit of the nodes' times
  std::vector<LegendEntry> legend;
  int width = 0, height = 0;  // [pixel] 64 to 16384; 0: chosen by the number of leaves
  Print print = {};
  // Labels all leaves, in letters as large as fit; a chosen width then makes them legible. In print letters that would
  // be smaller than small text are an InputError.
  bool labelsAll = false;
  std::optional<ColourBar> colourBar = {};  // explains the colours
};

/// Max number of labelled leaves; more would be illegible.
inline constexpr std::size_t maxLabelledLeaves = 40;

/// Draws the tree. Throws InputError for sizes out of range, paths with other letters than A and B, a path that appears
/// twice, and times that are not finite or run backward.
Drawing drawLineage(const TreePicture& picture);

}  // namespace morula

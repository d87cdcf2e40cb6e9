#pragma once
// The lineage tree as a picture: time runs downward, every cell is a vertical line from its birth to its end,
// its daughter A hangs to the left and B to the right.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "drawing/annotations.h"

namespace morula {

struct LineageNode {
  std::string path;  // '' the egg, then A/B letters
  double born = 0;   // [time]
  double ended = 0;  // [time]; for cells alive: the present
  Fate fate = Fate::alive;
  Colour colour = neutralGrey;
  std::string label;  // its name or state; written at leaves while there are few enough of them
};

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

/// The places of cells, before anything is drawn.
struct TreeLayout {
  std::vector<TreePlace> places;  // by path: a mother before her daughters, the A side before the B side
  std::size_t leaves = 0;
  double begin = 0, end = 0;  // [time] of the first birth and the last end
};

/// Checks the nodes and places them. The nodes must outlive the layout. Throws InputError as drawLineage does.
TreeLayout layoutTree(const std::vector<LineageNode>& nodes);

struct TreePicture {
  std::vector<LineageNode> nodes;  // in any order; each path once
  std::string title, caption;      // UTF-8
  std::string timeLabel = "time";  // of the axis, with the unit of the nodes' times
  std::vector<LegendEntry> legend;
  int width = 0, height = 0;  // [pixel] 64 to 16384; 0: what suits the number of leaves
  // Every leaf has its label, however many there are, in letters as large as there is room; the width that suits is
  // then one in which they can be read.
  bool labelsAll = false;
  std::optional<ColourBar> colourBar = {};  // what the colours tell
};

/// Leaves that are labelled at most; beyond that text would only be noise.
inline constexpr std::size_t maxLabelledLeaves = 40;

/// Throws InputError for sizes out of range, paths with other letters than A and B, a path that appears
/// twice, and times that are not finite or run backward.
Drawing drawLineage(const TreePicture& picture);

}  // namespace morula

#pragma once
// The lineage tree as a picture: time runs downward, every cell is a vertical line from its birth to its end,
// its daughter A hangs to the left and B to the right.
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

struct TreePicture {
  std::vector<LineageNode> nodes;  // in any order; each path once
  std::string title, caption;      // UTF-8
  std::vector<LegendEntry> legend;
  int width = 0, height = 0;  // [pixel] 64 to 16384; 0: what suits the number of leaves
};

/// Leaves that are labelled at most; beyond that text would only be noise.
inline constexpr std::size_t maxLabelledLeaves = 40;

/// Throws InputError for sizes out of range, paths with other letters than A and B, a path that appears
/// twice, and times that are not finite or run backward.
Drawing drawLineage(const TreePicture& picture);

}  // namespace morula

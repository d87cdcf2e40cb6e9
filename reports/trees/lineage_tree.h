#pragma once
// The lineage tree as a picture: time runs downward, every cell is a vertical line from its birth to its end,
// its daughter A hangs to the left and B to the right.
#include <optional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "drawing/annotations.h"
#include "drawing/colour_bar.h"

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

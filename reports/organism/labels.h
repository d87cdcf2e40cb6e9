#pragma once
// The places of labels in a picture: on their cells, or beside them with a line; no two labels touch.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

/// The cell that each pixel shows, row by row from the top, as its number from 1; 0: none.
struct LabelGround {
  int width = 0, height = 0;
  std::vector<std::uint32_t> owners;
};

struct LabelWish {
  std::uint32_t owner;     // the cell's number from 1
  std::string text;        // UTF-8
  std::optional<Spot> at;  // [pixel] place of a cell that owns no pixels
};

/// A label's box, and the spot of the cell that its leader line ends at.
struct PlacedLabel {
  std::string text;
  double left, top, right, bottom;  // [pixel]
  std::optional<Spot> leader;
};

/// Places labels, cells with much room first. Each label is put where its cell is widest, or at the nearest free place
/// around. Labels of hidden cells and labels without a free place are left out. The result does not depend on the order
/// of wishes with different numbers.
std::vector<PlacedLabel> placeLabels(const LabelGround& ground, const std::vector<LabelWish>& wishes, double textSize);

/// Draws the labels; the ground's upper left corner is at (left, top).
void drawLabels(Drawing& drawing, const std::vector<PlacedLabel>& labels, double left, double top, double textSize);

}  // namespace morula

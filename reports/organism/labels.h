#pragma once
// The places of words in a picture: each lies on its own cell, or beside it with a line to it, and no two touch.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

/// The cell that each pixel shows, row by row from the top: its number from 1; 0: none.
struct LabelGround {
  int width = 0, height = 0;
  std::vector<std::uint32_t> owners;
};

struct LabelWish {
  std::uint32_t owner;     // the cell's number from 1
  std::string text;        // UTF-8
  std::optional<Spot> at;  // of a cell that owns no pixels: where it is
};

/// A box of words, and the spot of the cell that a line leads to from it.
struct PlacedLabel {
  std::string text;
  double left, top, right, bottom;  // [pixel]
  std::optional<Spot> leader;
};

/// Cells with much room come first: each label is put where its cell is widest, or else around that place at the
/// nearest of some places that is free. What is not seen, or finds no place, is left out. The result does not
/// depend on the order of wishes with different numbers.
std::vector<PlacedLabel> placeLabels(const LabelGround& ground, const std::vector<LabelWish>& wishes, double textSize);

/// Draws them, the ground's upper left corner at (left, top).
void drawLabels(Drawing& drawing, const std::vector<PlacedLabel>& labels, double left, double top, double textSize);

}  // namespace morula

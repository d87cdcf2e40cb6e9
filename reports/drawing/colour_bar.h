#pragma once
// The colours of a quantity from its least to its greatest value, with both numbers.
#include <string>

#include "drawing/drawing.h"

namespace morula {

struct ColourBar {
  std::string title;  // of the quantity, with its unit
  double low = 0, high = 1;
  bool blank = false;  // room is kept for it, and nothing is drawn: for pictures beside one that has it
};

/// Draws it into a box from `topLeft`, `width` pixels wide and colourBarHeight high: the title, the colours of
/// scaleColour, the numbers below its two ends. One number alone where both are the same.
void drawColourBar(Drawing& drawing, const ColourBar& bar, Spot topLeft, double width, double textSize);

/// [pixel]
double colourBarHeight(double textSize);

}  // namespace morula

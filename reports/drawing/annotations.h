#pragma once
// Title, caption and legend: bands above and below a picture, so that words never cover what is shown.
#include <string>
#include <vector>

#include "drawing/marker.h"

namespace morula {

struct LegendEntry {
  Colour colour;
  std::string label;
  Marker marker = Marker::square;
  bool shown = true;  // else room is kept for it: pictures of a sequence have bands of one height
};

struct Annotations {
  std::string title, caption;  // UTF-8, one line each
  std::vector<LegendEntry> legend;
};

struct Bands {
  int top = 0, bottom = 0;  // [pixel]
};

/// The heights that the words need on a picture of this size: none without words, and never so much that the
/// middle loses more than half of the height. `textSize` [pixel]: of ordinary text; 0: textSizeFor's.
Bands bandsFor(const Annotations& annotations, int width, int height, double textSize = 0);

/// Draws the words into the bands of a drawing.
void annotate(Drawing& drawing, const Annotations& annotations, double textSize = 0);

/// [pixel] of ordinary text on a picture of this size.
double textSizeFor(int width, int height);

}  // namespace morula

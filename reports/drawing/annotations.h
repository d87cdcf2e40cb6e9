#pragma once
// Title, caption and legend: bands above and below a picture, so that words never cover the picture. Markers of several
// shapes tell colours apart in grey. A colour bar shows the colours of a quantity from its least to its greatest value.
#include <cstddef>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

enum class Marker { disc, square, triangle, diamond, hanging, plus, ring, cross };  // hanging: a triangle on its tip

/// Returns the marker of series number i, from 0: no two of the first seven are alike, and none is a cross.
Marker seriesMarker(std::size_t i);

/// Draws a marker around `centre`, about as large as a disc of this radius.
void drawMarker(Drawing& drawing, Spot centre, double radius, Colour colour, Marker marker);

struct LegendEntry {
  Colour colour;
  std::string label;
  Marker marker = Marker::square;
  bool shown = true;  // false: only keeps its place, so that nothing moves in a sequence
};

struct Annotations {
  std::string title, caption;  // UTF-8, broken into lines where the picture is narrow
  std::vector<LegendEntry> legend;
};

struct Bands {
  int top = 0, bottom = 0;  // [pixel]
};

/// Returns the heights that the words need on a picture of this size; both bands take at most half of the height.
/// `textSize` [pixel]: of ordinary text; 0: textSizeFor's.
Bands bandsFor(const Annotations& annotations, int width, int height, double textSize = 0);

/// Returns the bands around a middle of this height.
Bands bandsAround(int middle, const Annotations& annotations, int width, double textSize);

/// Draws the words into the bands of a drawing.
void annotate(Drawing& drawing, const Annotations& annotations, double textSize = 0);

/// Returns the size [pixel] of ordinary text on a picture of this size.
double textSizeFor(int width, int height, const Print& print = {});

struct ColourBar {
  std::string title;  // the quantity with its unit
  double low = 0, high = 1;
  bool blank = false;  // keeps room and draws nothing, for pictures beside one with a colour bar
};

/// Draws the colour bar into a box from `topLeft`, `width` pixels wide and colourBarHeight high: the title, the colours
/// of scaleColour, and the numbers below both ends; one number if both are equal.
void drawColourBar(Drawing& drawing, const ColourBar& bar, Spot topLeft, double width, double textSize);

double colourBarHeight(double textSize);

}  // namespace morula

#pragma once
// Scales of charts and trees: where numbers stand, which of them are written, and how an axis is drawn.
#include <limits>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

/// The numbers seen so far, from the least to the greatest.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void see(double value);
  /// Returns the place of a number between the two, 0 to 1; 0 if they are the same.
  double shareOf(double value) const;
};

struct Axis {
  enum class Scale { linear, decades, powersOfTwo };
  Scale scale = Scale::linear;
  double low = 0, high = 1;   // [unit of what is shown] above 0 unless linear
  double from = 0, to = 100;  // [pixel] where they stand; from > to for numbers that rise upwards

  /// [pixel] `from` if low and high are the same.
  double place(double value) const;

  /// The numbers to write, in rising order. Linear: round ones (1, 2 or 5 times a power of ten apart), about
  /// `wanted`. Decades: 1, 2 and 5 times the powers of ten, or powers of ten alone where there are many.
  /// Powers of two: all of them.
  std::vector<double> ticks(int wanted = 8) const;
};

/// The frame of a chart's lines; its axes run along the left and the lower side. [pixel]
struct ChartFrame {
  double left, top, right, bottom;
  double textSize;
};

/// Numbers along the frame's left side, a faint line across the frame for each, and the title, upright, left of them.
void drawUprightAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title);

/// Numbers below the frame, a faint line up through the frame for each, and the title below them.
void drawLevelAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title);

/// [pixel] What drawUprightAxis needs to the left of the frame and drawLevelAxis below it.
double roomForUprightAxis(const Axis& axis, double textSize);
double roomForLevelAxis(double textSize);

}  // namespace morula

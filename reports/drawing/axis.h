#pragma once
// Axes of charts and trees: where ticks stand and how an axis is drawn.
#include <limits>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

/// The range of the numbers seen so far.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void see(double value);
  /// Returns the place of a number in the range, 0 to 1; 0 if the range is a single number.
  double shareOf(double value) const;
};

/// The numbers that a quantity can be: those of a share end at 0 and 1.
struct AxisBounds {
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  double clamped(double value) const { return value < low ? low : value > high ? high : value; }
  /// Returns the range with `room` at both ends, but not beyond the bounds unless the range itself is.
  Range around(const Range& range, double room) const;
};

struct Axis {
  enum class Scale { linear, decades, powersOfTwo };
  Scale scale = Scale::linear;
  double low = 0, high = 1;   // [unit of the data] above 0 unless linear
  double from = 0, to = 100;  // [pixel] places of `low` and `high`; from > to for an upright axis

  /// Returns the place [pixel] of a value; `from` if low and high are equal.
  double place(double value) const;

  /// Returns the ticks in rising order. Linear: round numbers (1, 2 or 5 times a power of ten apart), about `wanted`.
  /// Decades: 1, 2 and 5 times the powers of ten, or powers of ten alone over many decades. Powers of two: all of them.
  std::vector<double> ticks(int wanted = 8) const;
};

/// The frame [pixel] of a chart's lines; its axes run along the left and the lower side.
struct ChartFrame {
  double left, top, right, bottom;
  double textSize;
};

/// Draws numbers along the frame's left side, a faint line across the frame for each, and left of them the upright
/// title.
void drawUprightAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title);

/// Draws numbers below the frame, a faint line up through the frame for each, and the title below the numbers.
void drawLevelAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title);

/// Return the room [pixel] that drawUprightAxis needs left of the frame, and drawLevelAxis below it.
double roomForUprightAxis(const Axis& axis, double textSize);
double roomForLevelAxis(double textSize);

}  // namespace morula

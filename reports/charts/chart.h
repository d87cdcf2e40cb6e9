#pragma once
// Charts of lines over two axes.
#include <string>
#include <vector>

#include "drawing/annotations.h"
#include "drawing/axis.h"

namespace morula {

struct ChartLine {
  std::string label;
  Colour colour;
  std::vector<Spot> points;  // sorted by x; both coordinates > 0 on logarithmic axes
  bool dashed = false;
  std::vector<std::string> pointLabels = {};  // one label for each point, or empty
};

/// A hollow point that no line goes through.
struct ChartMark {
  Spot at;  // both > 0
  Colour colour;
  std::string label;
};

struct Chart {
  std::string title, caption, xLabel, yLabel;
  std::vector<ChartLine> lines;
  std::vector<ChartMark> marks;
  Axis::Scale xScale = Axis::Scale::powersOfTwo, yScale = Axis::Scale::decades;
  std::vector<LegendEntry> legend = {};  // for lines that share colours
  bool dots = true;                      // markers at all points of lines; else at a few
  AxisBounds yBounds = {};               // on a linear axis
  int width = 1100, height = 760;        // [pixel] height 0: what suits
  Print print = {};
};

/// Draws the label of each line at its right end. For print in grey each colour has a marker of its own, at the points
/// of lines and in the legend; markers are assigned in the order of the lines. A chart without points shows its words
/// only.
Drawing drawChart(const Chart& chart);

}  // namespace morula

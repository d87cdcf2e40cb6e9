#pragma once
// Lines over two axes.
#include <string>
#include <vector>

#include "drawing/annotations.h"
#include "drawing/axis.h"

namespace morula {

struct ChartLine {
  std::string label;
  Colour colour;
  std::vector<Spot> points;  // by x; both > 0 where the axis is logarithmic
  bool dashed = false;
  std::vector<std::string> pointLabels = {};  // one for each point, or none at all
};

/// A point that no line goes through: a hollow one.
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
  std::vector<LegendEntry> legend = {};  // where lines share colours
  bool dots = true;                      // at all points of lines; else at a few
  int width = 1100, height = 760;        // [pixel]
};

/// Each line's label stands at its right end. Colours have shapes of their own at the points of lines and in the
/// legend, for print in grey: by the order in which lines bring the colours. Without points: the words alone.
Drawing drawChart(const Chart& chart);

}  // namespace morula

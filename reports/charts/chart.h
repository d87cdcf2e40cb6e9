#pragma once
// Lines over two logarithmic axes.
#include <string>
#include <vector>

#include "drawing/canvas.h"
#include "image/image.h"

namespace morula {

struct ChartLine {
  std::string label;
  Colour colour;
  std::vector<Spot> points;  // by x; both > 0
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
  enum class Scale { powersOfTwo, decades };
  std::string title, caption, xLabel, yLabel;
  std::vector<ChartLine> lines;
  std::vector<ChartMark> marks;
  Scale xScale = Scale::powersOfTwo;
  int width = 1100, height = 760;
};

/// y runs over 1, 2, 5, 10, …, or over powers of ten alone where there are many; so does x on decades. Each
/// line's label stands at its right end.
Image drawChart(const Chart& chart);

}  // namespace morula

#pragma once
// Lines over two logarithmic axes.
#include <string>
#include <vector>

#include "render/canvas.h"
#include "render/image.h"

namespace morula {

struct ChartLine {
  std::string label;
  Colour colour;
  std::vector<Spot> points;  // by x; both > 0
  bool dashed = false;
};

struct Chart {
  std::string title, caption, xLabel, yLabel;
  std::vector<ChartLine> lines;
  int width = 1100, height = 760;
};

/// x runs over powers of two, y over 1, 2, 5, 10, … Each line's label stands at its right end.
Image drawChart(const Chart& chart);

}  // namespace morula

#pragma once
// What changes over time, one line for each run, as a drawing.
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct TimeLine {
  std::string label;         // of the run; written only where there are several
  std::vector<Spot> points;  // time [time] and value, by time
  bool steps = false;        // it stays as it is up to the next point
};

struct TimeChart {
  std::string title, unit;  // "volume", "length³"
  std::vector<TimeLine> lines;
};

/// Both axes linear; the lines in the colours of palette.h, in their order.
Drawing drawTimeChart(const TimeChart& chart);

}  // namespace morula

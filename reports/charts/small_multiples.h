#pragma once
// Small multiples: panels side by side with scales of their own. A panel has strips of single values, or lines over
// time.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/annotations.h"
#include "drawing/axis.h"
#include "drawing/drawing.h"

namespace morula {

/// A strip shows all values of one group in a row, and below them their mean with its interval.
struct Strip {
  std::string label;  // consecutive strips with one label share it
  Colour colour;
  std::vector<double> values;  // drawn from top to bottom in this order
  double mean = 0;
  std::optional<std::pair<double, double>> interval{};  // low and high end
  Marker marker = Marker::disc;
};

/// A line shows one group over time, with the interval of the mean at each point.
struct PanelLine {
  Colour colour;
  std::vector<Spot> points;                               // sorted by x
  std::vector<std::pair<double, double>> intervals = {};  // one for each point, or empty
  Marker marker = Marker::disc;
};

struct Panel {
  std::string title;  // measure and unit, above the panel
  std::vector<Strip> strips;
  std::vector<PanelLine> lines;  // drawn if there are no strips
  std::string xLabel = {};       // title of the lines' x axis
  /// If true, a strip of more than `maxPoints` values shows their median, quartiles and range in place of points.
  bool counts = false;
  std::string meaning = {};  // of the measure, below the axis
  AxisBounds bounds = {};    // of the measure
};

inline constexpr std::size_t maxPoints = 6;

struct SmallMultiples {
  Annotations words;
  std::vector<Panel> panels;
  int panelWidth = 400;       // [pixel]
  int width = 0, height = 0;  // [pixel] width 0: that of the panels; the height follows from the panels
  Print print = {};
};

/// Draws panels as high as their strips need, in as few columns as suit a page. All words are horizontal. A single
/// panel is legible on a phone.
Drawing drawSmallMultiples(const SmallMultiples& chart);

}  // namespace morula

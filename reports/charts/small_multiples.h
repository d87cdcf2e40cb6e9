#pragma once
// Small multiples: panels side by side with scales of their own, each with strips of single values or with lines over
// time.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawing/annotations.h"
#include "drawing/drawing.h"

namespace morula {

/// All values of one group in a row, and below them their mean with its interval.
struct Strip {
  std::string label;  // strips behind each other with one label stand below it together
  Colour colour;
  std::vector<double> values;  // all are shown, in this order from top to bottom
  double mean = 0;
  std::optional<std::pair<double, double>> interval{};  // from low to high
  Marker marker = Marker::disc;
};

/// One group over time, with the band in which its mean lies.
struct PanelLine {
  Colour colour;
  std::vector<Spot> points;                               // by x
  std::vector<std::pair<double, double>> intervals = {};  // one for each point, or none at all
};

struct Panel {
  std::string title;  // above it: what is measured, and its unit
  std::vector<Strip> strips;
  std::vector<PanelLine> lines;  // where there are no strips
  std::string xLabel = {};       // of lines
  /// Max number of points of a strip. The median, quartiles and range of more values take the place of points that
  /// would lie on each other.
  bool counts = false;
};

inline constexpr std::size_t maxPoints = 6;

struct SmallMultiples {
  Annotations words;
  std::vector<Panel> panels;
  int panelWidth = 400;  // [pixel]
};

/// Panels as high as their strips need, in as few columns as suit a page. All words are level. One panel alone is
/// legible on a telephone.
Drawing drawSmallMultiples(const SmallMultiples& chart);

}  // namespace morula

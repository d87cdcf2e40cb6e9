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

/// All values of one group above each other, and beside them their mean with its interval.
struct Strip {
  std::string label;
  Colour colour;
  std::vector<double> values;  // all are shown, in this order from left to right
  double mean = 0;
  std::optional<std::pair<double, double>> interval{};  // from low to high
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
};

struct SmallMultiples {
  Annotations words;
  std::vector<Panel> panels;
  int panelWidth = 560, panelHeight = 400;  // [pixel]
};

/// The panels are laid out wider than high where that is possible. Labels of strips stand upright where they would touch.
Drawing drawSmallMultiples(const SmallMultiples& chart);

}  // namespace morula

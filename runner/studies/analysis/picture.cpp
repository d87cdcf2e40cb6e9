// A study's answer as a picture.
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/measure_words.h"
#include "analysis/study_comparison.h"
#include "charts/small_multiples.h"
#include "drawing/palette.h"
#include "files/text.h"
#include "views/measure_bounds.h"

namespace morula {
namespace {

/// Returns the axis that is shown by colour; absent without axes.
std::optional<std::size_t> colourAxis(const StudyComparison& c) {
  if (c.by.empty()) return std::nullopt;
  return c.by.front();
}

std::size_t colourLevel(const StudyComparison& c, std::size_t condition) {
  const auto axis = colourAxis(c);
  return axis ? c.results.conditions[condition].levels[*axis] : 0;
}

/// Returns the levels of the other axes; with one axis, its level.
std::string labelOf(const StudyComparison& c, std::size_t condition) {
  const auto& levels = c.results.conditions[condition].levels;
  const auto axis = colourAxis(c);
  std::vector<std::string> labels;
  for (std::size_t a = 0; a < levels.size(); ++a)
    if (levels.size() == 1) labels.push_back(c.results.axes[a].labels[levels[a]]);
    else if (a != axis) labels.push_back(c.results.axes[a].name + ": " + c.results.axes[a].labels[levels[a]]);
  return join(labels);
}

/// Adds what the measure means and can be.
void describe(Panel& panel, const std::string& measure, double factor) {
  const auto asked = findMeasure(measure);
  if (!asked) return;
  panel.meaning = shortMeaningOf(*asked);
  panel.bounds = boundsOf(*asked, factor);
}

Panel stripsOf(const StudyComparison& c, std::size_t measure, const Units& units) {
  const std::string& name = c.measureName(measure);
  const double factor = shownUnit(units, unitOfMeasure(name)).factor;
  Panel panel{titleOfMeasure(name, units), {}, {}};
  panel.counts = factor == 1;
  describe(panel, name, factor);
  std::map<std::string, std::vector<Strip>> byLabel;
  std::vector<std::string> order;  // labels in their order
  for (const ConditionSummary& s : c.conditions) {
    if (s.measure != measure || s.values.empty()) continue;
    for (const double v : s.values) panel.counts = panel.counts && v == std::floor(v);
    const std::string label = labelOf(c, s.condition);
    const std::size_t level = colourLevel(c, s.condition);
    std::vector<double> values = s.values;
    for (double& value : values) value *= factor;
    Strip strip{label, seriesColour(level), std::move(values), factor * s.mean, {}, seriesMarker(level)};
    if (s.interval) strip.interval = {factor * s.interval->low, factor * s.interval->high};
    if (!byLabel.contains(label)) order.push_back(label);
    byLabel[label].push_back(std::move(strip));
  }
  for (const std::string& label : order)
    for (Strip& strip : byLabel[label]) panel.strips.push_back(std::move(strip));
  return panel;
}

Panel coursesOf(const StudyComparison& c, std::size_t measure, const Units& units) {
  const std::string& name = c.measureName(measure);
  const double factor = shownUnit(units, unitOfMeasure(name)).factor, perTime = shownUnit(units, "time").factor;
  Panel panel{titleOfMeasure(name, units) + " over time", {}, {}, timeLabel(units)};
  describe(panel, name, factor);
  for (const TimeCourse& course : c.courses) {
    if (course.measure != measure) continue;
    const std::size_t level = colourLevel(c, course.condition);
    PanelLine line{.colour = seriesColour(level), .points = {}, .marker = seriesMarker(level)};
    for (const auto& p : course.points) {
      line.points.push_back({perTime * p.time, factor * p.mean});
      if (p.interval) line.intervals.push_back({factor * p.interval->low, factor * p.interval->high});
    }
    if (line.intervals.size() != line.points.size()) line.intervals.clear();
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

}  // namespace

SmallMultiples stripsOf(const StudyComparison& c, const Units& units) {
  SmallMultiples chart;
  chart.words.title = c.results.name;
  chart.words.caption =
      "Points: runs, one a seed; bars: mean and its 95 % interval. Whole numbers: median, quartiles, range.";
  if (const auto axis = colourAxis(c); axis && c.results.axes.size() > 1)
    for (std::size_t l = 0; l < c.results.axes[*axis].labels.size(); ++l)
      chart.words.legend.push_back(
          {seriesColour(l), c.results.axes[*axis].name + ": " + c.results.axes[*axis].labels[l], seriesMarker(l)});
  for (const std::size_t m : c.measures) chart.panels.push_back(stripsOf(c, m, units));
  for (const std::size_t m : c.measures)
    if (std::ranges::any_of(c.courses, [&](const TimeCourse& course) { return course.measure == m; }))
      chart.panels.push_back(coursesOf(c, m, units));
  return chart;
}

}  // namespace morula

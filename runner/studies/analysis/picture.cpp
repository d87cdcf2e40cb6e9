#include "analysis/picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/measure_words.h"
#include "charts/small_multiples.h"
#include "drawing/palette.h"
#include "files/text.h"

namespace morula {

namespace {

/// The axis that is told by colour; none without axes.
std::optional<std::size_t> colourAxis(const StudyComparison& c) {
  if (c.by.empty()) return std::nullopt;
  return c.by.front();
}

std::size_t colourLevel(const StudyComparison& c, std::size_t condition) {
  const auto axis = colourAxis(c);
  return axis ? c.results.conditions[condition].levels[*axis] : 0;
}

/// The levels of the other axes; of the only axis its own.
std::string labelOf(const StudyComparison& c, std::size_t condition) {
  const auto& levels = c.results.conditions[condition].levels;
  const auto axis = colourAxis(c);
  std::vector<std::string> labels;
  for (std::size_t a = 0; a < levels.size(); ++a)
    if (a != axis || levels.size() == 1) labels.push_back(c.results.axes[a].labels[levels[a]]);
  return join(labels);
}

Panel stripsOf(const StudyComparison& c, std::size_t measure) {
  Panel panel{.title = titleOfMeasure(c.measureName(measure)), .strips = {}, .lines = {}};
  std::vector<const ConditionSummary*> order;
  for (const ConditionSummary& s : c.conditions)
    if (s.measure == measure && !s.values.empty()) order.push_back(&s);
  std::ranges::stable_sort(order, {},
                           [&](const ConditionSummary* s) { return colourLevel(c, s->condition); });
  for (const ConditionSummary* s : order) {
    Strip strip{labelOf(c, s->condition), seriesColour(colourLevel(c, s->condition)), s->values, s->mean};
    if (s->interval) strip.interval = {s->interval->low, s->interval->high};
    panel.strips.push_back(std::move(strip));
  }
  return panel;
}

Panel coursesOf(const StudyComparison& c, std::size_t measure) {
  Panel panel{.title = titleOfMeasure(c.measureName(measure)) + " over time",
              .strips = {},
              .lines = {},
              .xLabel = "time"};
  for (const TimeCourse& course : c.courses) {
    if (course.measure != measure) continue;
    PanelLine line{seriesColour(colourLevel(c, course.condition)), {}};
    for (const auto& p : course.points) {
      line.points.push_back({p.time, p.mean});
      if (p.interval) line.intervals.push_back({p.interval->low, p.interval->high});
    }
    if (line.intervals.size() != line.points.size()) line.intervals.clear();
    panel.lines.push_back(std::move(line));
  }
  return panel;
}

}  // namespace

Drawing drawComparedStudy(const StudyComparison& c) {
  SmallMultiples chart;
  chart.words.title = c.results.name;
  chart.words.caption = "points: runs, one a seed; bars: mean and its 95 % interval";
  if (const auto axis = colourAxis(c); axis && c.results.axes.size() > 1)
    for (std::size_t l = 0; l < c.results.axes[*axis].labels.size(); ++l)
      chart.words.legend.push_back(
          {seriesColour(l), c.results.axes[*axis].name + ": " + c.results.axes[*axis].labels[l]});
  for (const std::size_t m : c.measures) chart.panels.push_back(stripsOf(c, m));
  for (const std::size_t m : c.measures)
    if (std::ranges::any_of(c.courses, [&](const TimeCourse& course) { return course.measure == m; }))
      chart.panels.push_back(coursesOf(c, m));
  return drawSmallMultiples(chart);
}

}  // namespace morula

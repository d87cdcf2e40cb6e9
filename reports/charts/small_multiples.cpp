#include "charts/small_multiples.h"

#include <algorithm>
#include <cmath>

#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {
namespace {

struct Place {
  double left, top, width, height;
};

std::size_t columnsFor(std::size_t panels) { return panels < 2 ? 1 : panels < 5 ? 2 : panels < 10 ? 3 : 4; }

/// A range with room at both ends; around a single number, too.
Axis axisOver(Range range, double share) {
  if (!(range.low <= range.high)) range = {0, 1};
  double room = share * (range.high - range.low);
  if (room == 0) room = range.low == 0 ? 1 : 0.05 * std::abs(range.low);
  return {.low = range.low - room, .high = range.high + room};
}

Range heights(const Panel& panel) {
  Range y;
  for (const Strip& strip : panel.strips) {
    for (const double v : strip.values) y.see(v);
    if (strip.interval) y.see(strip.interval->first), y.see(strip.interval->second);
  }
  if (!panel.strips.empty()) return y;
  for (const PanelLine& line : panel.lines) {
    for (const Spot& p : line.points) y.see(p.y);
    for (const auto& [low, high] : line.intervals) y.see(low), y.see(high);
  }
  return y;
}

/// How the labels below the strips stand, and what they need.
struct Labels {
  bool upright = false;
  double room = 0, most = 0;  // [pixel] below the frame; along the text
};

Labels labelsFor(const Panel& panel, double slot, double height, const TextStyle& style) {
  double widest = 0;
  for (const Strip& strip : panel.strips) widest = std::max(widest, textWidth(strip.label, style));
  if (widest < 0.94 * slot) return {false, 2 * style.size, slot};
  const double most = std::min(widest + 1, 0.4 * height);
  return {true, most + style.size, most};
}

void drawStrip(Drawing& drawing, const Strip& strip, const Axis& y, double left, double slot) {
  const double middle = left + 0.5 * slot, wide = 0.5 * slot;
  const std::size_t n = strip.values.size();
  const double radius = std::clamp(0.05 * slot, 1.6, 3.4);
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) - 0.5 : 0;
    drawing.disc({middle - 0.12 * slot + wide * share, y.place(strip.values[i])}, radius, strip.colour);
  }
  if (n == 0) return;
  const double at = middle + 0.32 * slot, mean = y.place(strip.mean);
  if (strip.interval)
    drawing.line({{at, y.place(strip.interval->first)}, {at, y.place(strip.interval->second)}},
                 {.width = 2, .colour = ink});
  drawing.line({{at - 0.1 * slot, mean}, {at + 0.1 * slot, mean}}, {.width = 2.6, .colour = ink});
}

void drawStrips(Drawing& drawing, const Panel& panel, const ChartFrame& frame, const Axis& y,
                const Labels& labels, const TextStyle& small) {
  const double slot = (frame.right - frame.left) / static_cast<double>(panel.strips.size());
  drawing.line({{frame.left, crisp(frame.bottom)}, {frame.right, crisp(frame.bottom)}}, {.colour = quietInk});
  for (std::size_t i = 0; i < panel.strips.size(); ++i) {
    const double left = frame.left + slot * static_cast<double>(i), middle = left + 0.5 * slot;
    drawStrip(drawing, panel.strips[i], y, left, slot);
    TextStyle style = small;
    style.upward = labels.upright;
    style.anchor = labels.upright ? Anchor::right : Anchor::centre;
    const Spot at = labels.upright ? Spot{middle + 0.36 * small.size, frame.bottom + 0.6 * small.size}
                                   : Spot{middle, frame.bottom + 1.5 * small.size};
    drawing.text(at, shortened(panel.strips[i].label, style, labels.most), style);
  }
}

void drawLines(Drawing& drawing, const Panel& panel, const ChartFrame& frame, const Axis& y) {
  Range range;
  for (const PanelLine& line : panel.lines)
    for (const Spot& p : line.points) range.see(p.x);
  Axis x = axisOver(range, 0);
  x.from = frame.left, x.to = frame.right;
  drawLevelAxis(drawing, frame, x, panel.xLabel);
  for (const PanelLine& line : panel.lines) {
    std::vector<Spot> places;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const Spot at{x.place(line.points[i].x), y.place(line.points[i].y)};
      places.push_back(at);
      if (line.intervals.empty()) continue;
      drawing.line({{at.x, y.place(line.intervals[i].first)}, {at.x, y.place(line.intervals[i].second)}},
                   {.width = 1, .colour = line.colour});
    }
    drawing.line(places, {.width = 2, .colour = line.colour});
  }
}

void drawPanel(Drawing& drawing, const Panel& panel, const Place& place, double size) {
  const TextStyle small{.size = 0.9 * size, .colour = quietInk};
  const TextStyle title{.size = size, .colour = ink, .bold = true};
  Axis y = axisOver(heights(panel), 0.05);
  ChartFrame frame{.left = place.left + roomForUprightAxis(y, size) - 0.5 * size,
                   .top = place.top + 2 * size,
                   .right = place.left + place.width - 1.5 * size,
                   .bottom = place.top + place.height - roomForLevelAxis(size),
                   .textSize = size};
  drawing.text({frame.left, place.top + size}, shortened(panel.title, title, frame.right - frame.left),
               title);
  Labels labels;
  if (!panel.strips.empty()) {
    const double slot = (frame.right - frame.left) / static_cast<double>(panel.strips.size());
    labels = labelsFor(panel, slot, place.height, small);
    frame.bottom = place.top + place.height - labels.room - size;
  }
  y.from = frame.bottom, y.to = frame.top;
  drawUprightAxis(drawing, frame, y, "");
  if (!panel.strips.empty()) drawStrips(drawing, panel, frame, y, labels, small);
  else if (!panel.lines.empty()) drawLines(drawing, panel, frame, y);
}

}  // namespace

Drawing drawSmallMultiples(const SmallMultiples& chart) {
  const std::size_t columns = columnsFor(chart.panels.size());
  const std::size_t rows = std::max<std::size_t>(1, (chart.panels.size() + columns - 1) / columns);
  const int width = static_cast<int>(columns) * chart.panelWidth,
            middle = static_cast<int>(rows) * chart.panelHeight;
  // The bands are of a picture of this size; they may take half of it at most.
  const Bands bands = bandsFor(chart.words, width, middle);
  Drawing drawing(width, middle + bands.top + bands.bottom);
  annotate(drawing, chart.words);
  const double size = 0.9 * textSizeFor(chart.panelWidth * 2, chart.panelHeight * 2);
  const Bands drawn = bandsFor(chart.words, drawing.width(), drawing.height());
  const double high = (drawing.height() - drawn.top - drawn.bottom) / static_cast<double>(rows);
  for (std::size_t i = 0; i < chart.panels.size(); ++i)
    drawPanel(
        drawing, chart.panels[i],
        {static_cast<double>(i % columns) * chart.panelWidth,
         drawn.top + static_cast<double>(i / columns) * high, static_cast<double>(chart.panelWidth), high},
        size);
  return drawing;
}

}  // namespace morula

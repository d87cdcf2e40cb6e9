#include "charts/small_multiples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr double size = 13;         // [pixel] text size
constexpr double row = 1.5 * size;  // [pixel] height of a strip

struct Place {
  double left, top, width, height;
};

/// Returns an axis with room at both ends of the range, also if the range is a single number.
Axis axisOver(Range range, double share) {
  if (!(range.low <= range.high)) range = {0, 1};
  double room = share * (range.high - range.low);
  if (room == 0) room = range.low == 0 ? 1 : 0.05 * std::abs(range.low);
  return {.low = range.low - room, .high = range.high + room};
}

Range valuesIn(const Panel& panel) {
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

bool startsGroup(const Panel& panel, std::size_t strip) {
  return strip == 0 || panel.strips[strip].label != panel.strips[strip - 1].label;
}

/// Returns the distance [pixel] from the top of a group to its first strip.
double headOf(const Strip& strip) { return strip.label.empty() ? 0.4 * size : 1.9 * size; }

int heightOf(const Panel& panel) {
  double height = 2 * size + 2.4 * size;  // title and numbers
  if (panel.strips.empty()) return static_cast<int>(height + 15 * size);
  for (std::size_t i = 0; i < panel.strips.size(); ++i)
    height += row + (startsGroup(panel, i) ? headOf(panel.strips[i]) : 0);
  return static_cast<int>(height + 0.4 * size);
}

/// Returns the quantile of sorted values at this share, interpolated linearly.
double quantile(const std::vector<double>& sorted, double share) {
  const double place = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double above = sorted[std::min(below + 1, sorted.size() - 1)];
  return sorted[below] + (place - static_cast<double>(below)) * (above - sorted[below]);
}

void drawCounts(Drawing& drawing, const Strip& strip, const Axis& x, double middle) {
  std::vector<double> sorted = strip.values;
  std::ranges::sort(sorted);
  drawing.line({{x.place(sorted.front()), middle}, {x.place(sorted.back()), middle}},
               {.width = 1.5, .colour = strip.colour});
  const double low = x.place(quantile(sorted, 0.25)), high = x.place(quantile(sorted, 0.75));
  drawing.box({low - 0.6 * row, middle - 0.25 * row}, high - low + 1.2 * row, 0.5 * row, strip.colour);
  const Spot median{x.place(quantile(sorted, 0.5)), middle};
  drawing.disc(median, 0.36 * row, paper);
  drawMarker(drawing, median, 0.25 * row, ink, strip.marker);
}

void drawStrip(Drawing& drawing, const Strip& strip, const Axis& x, double top, bool counts) {
  const std::size_t n = strip.values.size();
  if (n == 0) return;
  if (counts && n > maxPoints) return drawCounts(drawing, strip, x, top + 0.5 * row);
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5;
    drawMarker(drawing, {x.place(strip.values[i]), top + row * (0.12 + 0.42 * share)}, 2.6, strip.colour, strip.marker);
  }
  const double at = top + 0.78 * row, mean = x.place(strip.mean);
  if (strip.interval)
    drawing.line({{x.place(strip.interval->first), at}, {x.place(strip.interval->second), at}},
                 {.width = 2, .colour = ink});
  drawing.line({{mean, at - 0.16 * row}, {mean, at + 0.16 * row}}, {.width = 2.6, .colour = ink});
}

void drawStrips(Drawing& drawing, const Panel& panel, const ChartFrame& frame, const Axis& x) {
  drawLevelAxis(drawing, frame, x, "");
  double y = frame.top;
  for (std::size_t i = 0; i < panel.strips.size(); ++i) {
    const Strip& strip = panel.strips[i];
    if (startsGroup(panel, i)) {
      const TextStyle style{.size = size, .colour = ink, .halo = 2};
      y += headOf(strip);
      drawing.text({frame.left, y - 0.4 * size}, shortened(strip.label, style, frame.right - frame.left), style);
    }
    drawStrip(drawing, strip, x, y, panel.counts);
    y += row;
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

void drawPanel(Drawing& drawing, const Panel& panel, const Place& place) {
  const TextStyle title{.size = 1.05 * size, .colour = ink, .bold = true};
  Axis values = axisOver(valuesIn(panel), 0.05);
  ChartFrame frame{.left = place.left + 1.5 * size,
                   .top = place.top + 2 * size,
                   .right = place.left + place.width - 1.5 * size,
                   .bottom = place.top + heightOf(panel) - 2.4 * size,
                   .textSize = size};
  drawing.text({frame.left, place.top + 1.2 * size}, shortened(panel.title, title, place.width - 3 * size), title);
  if (panel.lines.empty()) {
    values.from = frame.left, values.to = frame.right;
    return drawStrips(drawing, panel, frame, values);
  }
  frame.left = place.left + roomForUprightAxis(values, size) - 0.5 * size;
  frame.bottom = place.top + place.height - roomForLevelAxis(size);
  values.from = frame.bottom, values.to = frame.top;
  drawUprightAxis(drawing, frame, values, "");
  drawLines(drawing, panel, frame, values);
}

/// Returns the height [pixel] of each row of panels.
std::vector<int> rowHeights(const std::vector<Panel>& panels, std::size_t columns) {
  std::vector<int> heights((panels.size() + columns - 1) / columns);
  for (std::size_t i = 0; i < panels.size(); ++i)
    heights[i / columns] = std::max(heights[i / columns], heightOf(panels[i]));
  return heights;
}

}  // namespace

Drawing drawSmallMultiples(const SmallMultiples& chart) {
  constexpr double page = 1.42;  // max height over width
  constexpr std::size_t maxColumns = 4;
  std::size_t columns = 1;
  std::vector<int> heights;
  for (;; ++columns) {
    heights = rowHeights(chart.panels, columns);
    if (columns == std::min(maxColumns, std::max<std::size_t>(1, chart.panels.size())) ||
        std::accumulate(heights.begin(), heights.end(), 0) <= page * static_cast<double>(columns) * chart.panelWidth)
      break;
  }
  const int width = static_cast<int>(columns) * chart.panelWidth,
            middle = std::max(16, std::accumulate(heights.begin(), heights.end(), 0));
  const Bands bands = bandsAround(middle, chart.words, width, size);
  Drawing drawing(width, middle + bands.top + bands.bottom);
  annotate(drawing, chart.words, size);
  double top = bands.top;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    drawPanel(drawing, chart.panels[i],
              {static_cast<double>(i % columns) * chart.panelWidth, top, static_cast<double>(chart.panelWidth),
               static_cast<double>(heights[i / columns])});
    if (i % columns + 1 == columns) top += heights[i / columns];
  }
  return drawing;
}

}  // namespace morula

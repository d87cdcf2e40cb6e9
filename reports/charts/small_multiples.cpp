#include "charts/small_multiples.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr double size = figureText;    // [pixel]
constexpr double row = 1.5 * size;     // [pixel] height of a strip
constexpr double margin = 1.5 * size;  // [pixel] beside a panel's words

struct Place {
  double left, top, width, height;
};

/// Returns an axis with room at both ends of the range, also if the range is a single number.
Axis axisOver(Range range, double share, const AxisBounds& bounds = {}) {
  if (!(range.low <= range.high)) range = {0, 1};
  double room = share * (range.high - range.low);
  if (room == 0) room = range.low == 0 ? 1 : 0.05 * std::abs(range.low);
  range = bounds.around(range, room);
  return {.low = range.low, .high = range.high};
}

Range valuesIn(const Panel& panel) {
  Range y;
  const auto bounds = [&](double value) { return panel.bounds.clamped(value); };
  for (const Strip& strip : panel.strips) {
    for (const double v : strip.values) y.see(v);
    if (strip.interval) y.see(bounds(strip.interval->first)), y.see(bounds(strip.interval->second));
  }
  if (!panel.strips.empty()) return y;
  for (const PanelLine& line : panel.lines) {
    for (const Spot& p : line.points) y.see(p.y);
    for (const auto& [low, high] : line.intervals) y.see(bounds(low)), y.see(bounds(high));
  }
  return y;
}

bool startsGroup(const Panel& panel, std::size_t strip) {
  return strip == 0 || panel.strips[strip].label != panel.strips[strip - 1].label;
}

const TextStyle titleStyle{.size = size, .colour = ink, .bold = true},
    labelStyle{.size = size, .colour = ink, .halo = 2}, meaningStyle{.size = smallText * size, .colour = quietInk};
constexpr double lineHeight = 1.3 * size;  // [pixel]

/// Returns the height [pixel] of the lines that a text has in a panel of this width; 0 without text.
double linesHeight(const std::string& text, const TextStyle& style, double width) {
  return text.empty() ? 0 : lineHeight * static_cast<double>(wrapped(text, style, width - 2 * margin).size());
}

/// Draws the text's lines, the first one's baseline a line below `top`.
void drawLines(Drawing& drawing, const std::string& text, const TextStyle& style, const Place& place, double top) {
  if (text.empty()) return;
  for (const std::string& line : wrapped(text, style, place.width - 2 * margin))
    drawing.text({place.left + margin, top += lineHeight}, line, style);
}

/// Returns the distance [pixel] from the top of a group to its first strip.
double headOf(const Strip& strip, double width) { return 0.5 * size + linesHeight(strip.label, labelStyle, width); }

int heightOf(const Panel& panel, double width) {
  // Besides the words: room above the title and below, and the axis' numbers.
  double height = 0.8 * size + linesHeight(panel.title, titleStyle, width) + 2.6 * size +
                  linesHeight(panel.meaning, meaningStyle, width);
  if (panel.strips.empty()) return static_cast<int>(height + 15 * size);
  for (std::size_t i = 0; i < panel.strips.size(); ++i)
    height += row + (startsGroup(panel, i) ? headOf(panel.strips[i], width) : 0);
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

void drawStrip(Drawing& drawing, const Strip& strip, const Axis& x, double top, const Panel& panel) {
  const std::size_t n = strip.values.size();
  if (n == 0) return;
  if (panel.counts && n > maxPoints) return drawCounts(drawing, strip, x, top + 0.5 * row);
  for (std::size_t i = 0; i < n; ++i) {
    const double share = n > 1 ? static_cast<double>(i) / static_cast<double>(n - 1) : 0.5;
    drawMarker(drawing, {x.place(strip.values[i]), top + row * (0.12 + 0.42 * share)}, 2.6, strip.colour, strip.marker);
  }
  const double at = top + 0.78 * row, mean = x.place(strip.mean);
  if (strip.interval)
    drawing.line({{x.place(panel.bounds.clamped(strip.interval->first)), at},
                  {x.place(panel.bounds.clamped(strip.interval->second)), at}},
                 {.width = 2, .colour = ink});
  drawing.line({{mean, at - 0.16 * row}, {mean, at + 0.16 * row}}, {.width = 2.6, .colour = ink});
}

void drawStrips(Drawing& drawing, const Panel& panel, const Place& place, const ChartFrame& frame, const Axis& x) {
  drawLevelAxis(drawing, frame, x, "");
  double y = frame.top;
  for (std::size_t i = 0; i < panel.strips.size(); ++i) {
    const Strip& strip = panel.strips[i];
    if (startsGroup(panel, i)) {
      drawLines(drawing, strip.label, labelStyle, place, y);
      y += headOf(strip, place.width);
    }
    drawStrip(drawing, strip, x, y, panel);
    y += row;
  }
}

void drawCourses(Drawing& drawing, const Panel& panel, const ChartFrame& frame, const Axis& y) {
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
      const auto [low, high] = line.intervals[i];
      drawing.line({{at.x, y.place(panel.bounds.clamped(low))}, {at.x, y.place(panel.bounds.clamped(high))}},
                   {.width = 1, .colour = line.colour});
    }
    drawing.line(places, {.width = 2, .colour = line.colour});
    // Lines that lie on each other have their markers at different points.
    const std::size_t step = std::max<std::size_t>(1, places.size() / 6);
    for (std::size_t i = static_cast<std::size_t>(&line - panel.lines.data()) % step; i < places.size(); i += step)
      drawMarker(drawing, places[i], 3.6, line.colour, line.marker);
  }
}

void drawPanel(Drawing& drawing, const Panel& panel, const Place& place) {
  Axis values = axisOver(valuesIn(panel), 0.05, panel.bounds);
  const double meaning = linesHeight(panel.meaning, meaningStyle, place.width);
  ChartFrame frame{.left = place.left + margin,
                   .top = place.top + 0.8 * size + linesHeight(panel.title, titleStyle, place.width),
                   .right = place.left + place.width - margin,
                   .bottom = place.top + heightOf(panel, place.width) - 2.6 * size - meaning,
                   .textSize = size};
  drawLines(drawing, panel.title, titleStyle, place, place.top);
  const bool strips = panel.lines.empty();
  drawLines(drawing, panel.meaning, meaningStyle, place,
            strips ? frame.bottom + 1.7 * size : place.top + place.height - meaning - 0.5 * size);
  if (strips) {
    values.from = frame.left, values.to = frame.right;
    return drawStrips(drawing, panel, place, frame, values);
  }
  frame.left = place.left + roomForUprightAxis(values, size) - 0.5 * size;
  frame.bottom = place.top + place.height - roomForLevelAxis(size) - meaning;
  values.from = frame.bottom, values.to = frame.top;
  drawUprightAxis(drawing, frame, values, "");
  drawCourses(drawing, panel, frame, values);
}

/// Returns the height [pixel] of each row of panels.
std::vector<int> rowHeights(const std::vector<Panel>& panels, std::size_t columns, double width) {
  std::vector<int> heights((panels.size() + columns - 1) / columns);
  for (std::size_t i = 0; i < panels.size(); ++i)
    heights[i / columns] = std::max(heights[i / columns], heightOf(panels[i], width));
  return heights;
}

}  // namespace

Drawing drawSmallMultiples(const SmallMultiples& chart) {
  constexpr double page = 1.42;         // max height over width
  constexpr double narrow = 25 * size;  // [pixel] of a panel
  const std::size_t most = std::min<std::size_t>(4, std::max<std::size_t>(1, chart.panels.size()));
  std::size_t columns = chart.width ? std::clamp<std::size_t>(chart.width / static_cast<int>(narrow), 1, most) : 1;
  const double panelWidth = chart.width ? chart.width / static_cast<double>(columns) : chart.panelWidth;
  std::vector<int> heights;
  for (;; ++columns) {
    heights = rowHeights(chart.panels, columns, panelWidth);
    if (chart.width || columns == most ||
        std::accumulate(heights.begin(), heights.end(), 0) <= page * static_cast<double>(columns) * panelWidth)
      break;
  }
  const int width = chart.width ? chart.width : static_cast<int>(columns) * chart.panelWidth,
            middle = std::max(16, std::accumulate(heights.begin(), heights.end(), 0));
  const Bands bands = bandsAround(middle, chart.words, width, size);
  Drawing drawing(width, middle + bands.top + bands.bottom, Drawing::Ground::paper, chart.print);
  annotate(drawing, chart.words, size);
  double top = bands.top;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    drawPanel(
        drawing, chart.panels[i],
        {static_cast<double>(i % columns) * panelWidth, top, panelWidth, static_cast<double>(heights[i / columns])});
    if (i % columns + 1 == columns) top += heights[i / columns];
  }
  return drawing;
}

}  // namespace morula

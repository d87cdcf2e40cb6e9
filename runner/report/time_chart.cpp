#include "report/time_chart.h"

#include <algorithm>

#include "drawing/annotations.h"
#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {

namespace {

constexpr int width = 640, height = 400;  // [pixel]

/// A little more than the data, so that no line runs along the frame.
void widen(Range& range, double share) {
  const double more = range.high > range.low ? share * (range.high - range.low)
                      : range.high != 0      ? 0.05 * std::abs(range.high)
                                             : 1;
  range.low -= more, range.high += more;
}

std::vector<Spot> placesOf(const TimeLine& line, const Axis& x, const Axis& y) {
  std::vector<Spot> places;
  for (const Spot& p : line.points) {
    const Spot place{x.place(p.x), y.place(p.y)};
    if (line.steps && !places.empty()) places.push_back({place.x, places.back().y});
    places.push_back(place);
  }
  return places;
}

}  // namespace

Drawing drawTimeChart(const TimeChart& chart) {
  Annotations words{chart.title, "", {}};
  if (chart.lines.size() > 1)
    for (std::size_t i = 0; i < chart.lines.size(); ++i)
      words.legend.push_back({seriesColour(i), chart.lines[i].label});
  Drawing drawing(width, height);
  annotate(drawing, words);
  Range time, value;
  for (const TimeLine& line : chart.lines)
    for (const Spot& p : line.points) time.see(p.x), value.see(p.y);
  if (!(time.low <= time.high)) return drawing;
  if (time.low == time.high) widen(time, 0);
  widen(value, 0.05);
  const Bands bands = bandsFor(words, width, height);
  const double size = textSizeFor(width, height);
  Axis x{.low = time.low, .high = time.high}, y{.low = value.low, .high = value.high};
  const ChartFrame frame{.left = roomForUprightAxis(y, size),
                         .top = bands.top + size,
                         .right = width - 1.5 * size,
                         .bottom = height - bands.bottom - roomForLevelAxis(size),
                         .textSize = size};
  x.from = frame.left, x.to = frame.right;
  y.from = frame.bottom, y.to = frame.top;
  drawLevelAxis(drawing, frame, x, "time");
  drawUprightAxis(drawing, frame, y, chart.unit);
  for (std::size_t i = 0; i < chart.lines.size(); ++i) {
    const auto places = placesOf(chart.lines[i], x, y);
    drawing.line(places, {.width = 2, .colour = seriesColour(i), .dashed = i >= fewSeries});
    if (chart.lines[i].points.size() < 3)
      for (const Spot& p : places) drawing.disc(p, 3, seriesColour(i));
  }
  return drawing;
}

}  // namespace morula

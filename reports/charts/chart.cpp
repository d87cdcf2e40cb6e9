#include "charts/chart.h"

#include <algorithm>
#include <cmath>

#include "drawing/annotations.h"

namespace morula {
namespace {

struct Sheet {
  ChartFrame frame;
  Axis x, y;
  Spot place(const Spot& p) const { return {x.place(p.x), y.place(p.y)}; }
};

std::vector<Spot> allPoints(const Chart& chart) {
  std::vector<Spot> points;
  for (const ChartLine& line : chart.lines) points.insert(points.end(), line.points.begin(), line.points.end());
  for (const ChartMark& mark : chart.marks) points.push_back(mark.at);
  return points;
}

double widestLabel(const Chart& chart, double size) {
  double widest = 0;
  for (const ChartLine& line : chart.lines) widest = std::max(widest, textWidth(line.label, {.size = size}));
  return widest;
}

Sheet makeSheet(const Chart& chart, const Annotations& words) {
  const double size = textSizeFor(chart.width, chart.height, chart.print);
  const Bands bands = bandsFor(words, chart.width, chart.height, size);
  Range x, y;
  for (const Spot& p : allPoints(chart)) x.see(p.x), y.see(p.y);
  if (chart.xScale == Axis::Scale::decades) x.low *= 0.8, x.high *= 1.25;
  const bool levelIsLinear = chart.xScale == Axis::Scale::linear, upIsLinear = chart.yScale == Axis::Scale::linear;
  if (!(x.low < x.high)) {
    if (levelIsLinear) x.low -= 0.5, x.high += 0.5;
    else x.low /= 2, x.high *= 2;
  }
  if (upIsLinear) {  // room above and below the values; a horizontal line gets room too
    const double room = y.low < y.high ? 0.04 * (y.high - y.low) : std::max(1e-300, 0.1 * std::abs(y.low));
    y = chart.yBounds.around(y, room);
  } else y.low *= 0.8, y.high *= 1.25;
  Sheet sheet{.frame = {.left = 0,
                        .top = bands.top + size,
                        .right = chart.width - widestLabel(chart, size) - 2.5 * size,
                        .bottom = chart.height - bands.bottom - roomForLevelAxis(size),
                        .textSize = size},
              .x = {.scale = chart.xScale, .low = x.low, .high = x.high},
              .y = {.scale = chart.yScale, .low = y.low, .high = y.high}};
  sheet.frame.left = roomForUprightAxis(sheet.y, size);
  sheet.x.from = sheet.frame.left, sheet.x.to = sheet.frame.right;
  sheet.y.from = sheet.frame.bottom, sheet.y.to = sheet.frame.top;
  return sheet;
}

struct Box {
  double left, top, right, bottom;
  bool touches(const Box& b) const { return left < b.right && b.left < right && top < b.bottom && b.top < bottom; }
};

Box around(Spot p, double reach) { return {p.x - reach, p.y - reach, p.x + reach, p.y + reach}; }

/// Puts labels beside their points. Of twelve places it takes the one where the label covers the fewest points and
/// labels; among equals, the fewest lines.
class PointLabels {
 public:
  PointLabels(Drawing& drawing, const Sheet& sheet, const Chart& chart) : drawing_(drawing), sheet_(sheet) {
    for (const Spot& point : allPoints(chart)) taken_.push_back(around(sheet.place(point), 4));
    for (const ChartLine& line : chart.lines)
      for (std::size_t i = 1; i < line.points.size(); ++i) {
        const Spot a = sheet.place(line.points[i - 1]), b = sheet.place(line.points[i]);
        const int steps = 1 + int(std::hypot(b.x - a.x, b.y - a.y) / 4);
        for (int k = 0; k <= steps; ++k)
          lines_.push_back(around({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps}, 1));
      }
  }

  void add(const Spot& point, const std::string& label, Colour colour) {
    if (label.empty()) return;
    const double textSize = sheet_.frame.textSize, gap = 0.5 * textSize;
    const TextStyle style{.size = smallText * textSize, .colour = colour};
    const Spot p = sheet_.place(point);
    const double wide = textWidth(label, style);
    const auto at = [&](int turn) {
      const double x = turn % 2 == 0 ? p.x + gap : p.x - gap - wide;                       // right, left, right, left
      const double y = p.y + (turn / 2 % 2 == 0 ? -1 : 1) * (0.35 + turn / 4) * textSize;  // above, above, below, below
      return Box{x, y - style.size, x + wide, y + 0.25 * style.size};
    };
    Box box = at(0);
    std::ptrdiff_t least = PTRDIFF_MAX;
    for (int turn = 0; turn < 12; ++turn) {
      const Box other = at(turn);
      if (other.right > sheet_.frame.right || other.left < sheet_.frame.left) continue;
      const auto covered = [&](const std::vector<Box>& boxes) {
        return std::count_if(boxes.begin(), boxes.end(), [&](const Box& b) { return b.touches(other); });
      };
      if (const auto cost = 1000 * covered(taken_) + covered(lines_); cost < least) least = cost, box = other;
    }
    taken_.push_back(box);
    drawing_.text({box.left, box.top + style.size}, label, style);
  }

 private:
  Drawing& drawing_;
  const Sheet& sheet_;
  std::vector<Box> taken_, lines_;
};

/// Assigns a marker to each colour, so that lines also differ without colour.
class Shapes {
 public:
  explicit Shapes(const Chart& chart) {
    for (const ChartLine& line : chart.lines)
      if (std::find(colours_.begin(), colours_.end(), line.colour) == colours_.end()) colours_.push_back(line.colour);
    shown_ = chart.dots || chart.lines.size() <= maxLines;
  }
  Marker of(Colour colour) const {
    return seriesMarker(std::size_t(std::find(colours_.begin(), colours_.end(), colour) - colours_.begin()));
  }
  bool tellApart() const { return shown_ && colours_.size() > 1; }

 private:
  static constexpr std::size_t maxLines = 200;  // more lines have markers only with dots, which else would hide them
  std::vector<Colour> colours_;
  bool shown_ = false;
};

/// Draws sparse markers on lines without dots, shifted from line to line.
void drawSparseMarks(Drawing& drawing, const std::vector<std::vector<Spot>>& lines, const Chart& chart,
                     const Shapes& shapes) {
  constexpr double apart = 130;  // [pixel]
  if (!shapes.tellApart()) return;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    double left = apart * (0.25 + 0.5 * double(l % 7) / 7);  // [pixel] to the next mark
    bool any = false;
    const auto mark = [&](Spot at) {
      drawMarker(drawing, at, 4, chart.lines[l].colour, shapes.of(chart.lines[l].colour));
      any = true;
    };
    for (std::size_t i = 1; i < lines[l].size(); ++i) {
      left -= std::hypot(lines[l][i].x - lines[l][i - 1].x, lines[l][i].y - lines[l][i - 1].y);
      if (left > 0) continue;
      mark(lines[l][i]);
      left = apart;
    }
    if (!any && !lines[l].empty()) mark(lines[l].back());
  }
}

/// Draws labels beside the ends of their lines and moves touching ones apart.
void drawLabels(Drawing& drawing, const Sheet& sheet, const Chart& chart, const Shapes& shapes) {
  struct Label {
    const ChartLine* line;
    double y;
  };
  std::vector<Label> labels;
  for (const ChartLine& line : chart.lines)
    if (!line.points.empty() && !line.label.empty()) labels.push_back({&line, sheet.place(line.points.back()).y});
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  const double size = sheet.frame.textSize, pitch = 1.25 * size;
  for (int turn = 0; turn < 200; ++turn)
    for (std::size_t i = 1; i < labels.size(); ++i)
      if (const double missing = pitch - (labels[i].y - labels[i - 1].y); missing > 0)
        labels[i - 1].y -= 0.5 * missing, labels[i].y += 0.5 * missing;
  for (const Label& label : labels) {
    const Colour colour = label.line->colour;
    if (shapes.tellApart())
      drawMarker(drawing, {sheet.frame.right + 0.85 * size, label.y}, 0.3 * size, colour, shapes.of(colour));
    drawing.text({sheet.frame.right + (shapes.tellApart() ? 1.5 : 0.8) * size, label.y + 0.36 * size},
                 label.line->label, {.size = size, .colour = colour});
  }
}

}  // namespace

Drawing drawChart(const Chart& asked) {
  Chart chart = asked;
  const Shapes shapes(chart);
  Annotations words{chart.title, chart.caption, chart.legend};
  if (shapes.tellApart())
    for (LegendEntry& entry : words.legend) entry.marker = shapes.of(entry.colour);
  if (chart.height == 0) {
    const Bands bands = bandsAround(int(0.75 * chart.width), words, chart.width, chart.print.textSize);
    chart.height = int(0.75 * chart.width) + bands.top + bands.bottom;
  }
  Drawing drawing(chart.width, chart.height, Drawing::Ground::paper, chart.print);
  annotate(drawing, words, chart.print.textSize);
  if (allPoints(chart).empty()) return drawing;
  const Sheet sheet = makeSheet(chart, words);
  drawLevelAxis(drawing, sheet.frame, sheet.x, chart.xLabel);
  drawUprightAxis(drawing, sheet.frame, sheet.y, chart.yLabel);
  std::vector<std::vector<Spot>> places;
  for (const ChartLine& line : chart.lines) {
    places.emplace_back();
    for (const Spot& p : line.points) places.back().push_back(sheet.place(p));
    drawing.line(places.back(), {.width = 2.2, .colour = line.colour, .dashed = line.dashed});
    for (const Spot& p : places.back())
      if (chart.dots) drawMarker(drawing, p, 3.6, line.colour, shapes.of(line.colour));
  }
  if (!chart.dots) drawSparseMarks(drawing, places, chart, shapes);
  for (const ChartMark& mark : chart.marks) {
    drawing.disc(sheet.place(mark.at), 4.4, mark.colour);
    drawing.disc(sheet.place(mark.at), 2.8, paper);
  }
  PointLabels labels(drawing, sheet, chart);
  for (const ChartLine& line : chart.lines)
    for (std::size_t i = 0; i < line.pointLabels.size(); ++i)
      labels.add(line.points[i], line.pointLabels[i], line.colour);
  for (const ChartMark& mark : chart.marks) labels.add(mark.at, mark.label, mark.colour);
  drawLabels(drawing, sheet, chart, shapes);
  return drawing;
}

}  // namespace morula

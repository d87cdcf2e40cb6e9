#include "charts/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing/annotations.h"
#include "drawing/text.h"

namespace morula {

namespace {

constexpr Colour axisInk{0x6a, 0x70, 0x77}, gridInk{0xe6, 0xe6, 0xe2};
constexpr double manyDecades = 2e3;            // from here on powers of ten alone
constexpr double dashLength = 9, dashGap = 6;  // [pixel]

struct Range {
  double low = 1e300, high = 0;
  void see(double a) { low = std::min(low, a), high = std::max(high, a); }
};

/// Where numbers lie in the picture.
struct Sheet {
  double left, top, right, bottom, textSize;  // [pixel]
  Range xRange, yRange;

  Spot place(const Spot& p) const {
    const auto share = [](double a, const Range& r) {
      return std::log(a / r.low) / std::log(r.high / r.low);
    };
    return {left + (right - left) * share(p.x, xRange), bottom - (bottom - top) * share(p.y, yRange)};
  }
};

std::vector<Spot> allPoints(const Chart& chart) {
  std::vector<Spot> points;
  for (const ChartLine& line : chart.lines)
    points.insert(points.end(), line.points.begin(), line.points.end());
  for (const ChartMark& mark : chart.marks) points.push_back(mark.at);
  return points;
}

double widestLabel(const Chart& chart, double size) {
  double widest = 0;
  for (const ChartLine& line : chart.lines) widest = std::max(widest, textWidth(line.label, {.size = size}));
  return widest;
}

/// Numbers to write beside an axis.
std::vector<double> ticks(const Range& range, Chart::Scale scale) {
  std::vector<double> list;
  const auto add = [&](double a) {
    if (a >= range.low && a <= range.high) list.push_back(a);
  };
  if (scale == Chart::Scale::powersOfTwo)
    for (int power = 0; power < 24; ++power) add(std::ldexp(1.0, power));
  else
    for (int decade = -18; decade < 9; ++decade)
      for (const double digit : {1.0, 2.0, 5.0})
        if (digit == 1 || range.high / range.low < manyDecades) add(digit * std::pow(10.0, decade));
  return list;
}

constexpr double tickSize = 0.9;  // of the text

/// [pixel] Of the numbers beside the vertical axis.
double widestTick(const Range& range, double textSize) {
  double widest = 0;
  for (const double y : ticks(range, Chart::Scale::decades))
    widest = std::max(widest, textWidth(fmt::format("{:g}", y), {.size = tickSize * textSize}));
  return widest;
}

Sheet makeSheet(const Chart& chart, const Annotations& words) {
  const Bands bands = bandsFor(words, chart.width, chart.height);
  Sheet s{};
  s.textSize = textSizeFor(chart.width, chart.height);
  s.right = chart.width - widestLabel(chart, s.textSize) - 2.5 * s.textSize;
  s.top = bands.top + s.textSize;
  s.bottom = chart.height - bands.bottom - 4 * s.textSize;
  for (const Spot& p : allPoints(chart)) s.xRange.see(p.x), s.yRange.see(p.y);
  if (chart.xScale == Chart::Scale::decades) s.xRange.low *= 0.8, s.xRange.high *= 1.25;
  s.yRange.low *= 0.8, s.yRange.high *= 1.25;
  if (!(s.xRange.low < s.xRange.high)) s.xRange = {s.xRange.low / 2, 2 * s.xRange.low};
  // From the edge: half a line, the upright title, half a line, the numbers, and their distance to the axis.
  s.left = std::max(5.5 * s.textSize, 2.6 * s.textSize + widestTick(s.yRange, s.textSize));
  return s;
}

void drawAxes(Image& image, const Sheet& s, const Chart& chart) {
  const double small = tickSize * s.textSize;
  for (const double x : ticks(s.xRange, chart.xScale)) {
    const double px = std::floor(s.place({x, s.yRange.low}).x) + 0.5;
    drawStroke(image, {{px, s.top}, {px, s.bottom}}, 1, gridInk);
    drawText(image, px, s.bottom + 1.4 * s.textSize, fmt::format("{:g}", x),
             {.size = small, .colour = axisInk, .anchor = Anchor::centre});
  }
  for (const double y : ticks(s.yRange, Chart::Scale::decades)) {
    const double py = std::floor(s.place({s.xRange.low, y}).y) + 0.5;
    drawStroke(image, {{s.left, py}, {s.right, py}}, 1, gridInk);
    drawText(image, s.left - 0.6 * s.textSize, py + 0.36 * s.textSize, fmt::format("{:g}", y),
             {.size = small, .colour = axisInk, .anchor = Anchor::right});
  }
  drawStroke(image, {{s.left, s.top}, {s.left, s.bottom}, {s.right, s.bottom}}, 1, axisInk);
  drawText(image, 0.5 * (s.left + s.right), s.bottom + 3 * s.textSize, chart.xLabel,
           {.size = s.textSize, .colour = axisInk, .anchor = Anchor::centre});
  drawText(image, 1.5 * s.textSize, 0.5 * (s.top + s.bottom), chart.yLabel,
           {.size = s.textSize, .colour = axisInk, .anchor = Anchor::centre, .upward = true});
}

void drawDashed(Image& image, const std::vector<Spot>& points, double width, Colour colour) {
  double along = 0;  // since the last dash began
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Spot a = points[i - 1], b = points[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto at = [&](double s) {
      return Spot{a.x + (b.x - a.x) * s / length, a.y + (b.y - a.y) * s / length};
    };
    for (double s = 0; s < length;) {
      const bool ink = along < dashLength;
      const double step = std::min(length - s, (ink ? dashLength : dashLength + dashGap) - along);
      if (ink) drawStroke(image, {at(s), at(s + step)}, width, colour);
      s += step;
      along += step;
      if (along >= dashLength + dashGap - 1e-9) along = 0;
    }
  }
}

struct Box {
  double left, top, right, bottom;
  bool touches(const Box& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

/// Labels beside their points, each at the nearest place of a few where it covers neither a point nor another
/// label.
class PointLabels {
 public:
  PointLabels(Image& image, const Sheet& sheet, const Chart& chart) : image_(image), sheet_(sheet) {
    constexpr double reach = 4;
    for (const Spot& point : allPoints(chart)) {
      const Spot p = sheet.place(point);
      taken_.push_back({p.x - reach, p.y - reach, p.x + reach, p.y + reach});
    }
  }

  void add(const Spot& point, const std::string& label, Colour colour) {
    const double size = 0.75 * sheet_.textSize, gap = 0.5 * sheet_.textSize;
    const Spot p = sheet_.place(point);
    const double wide = textWidth(label, {.size = size});
    const auto at = [&](int turn) {
      const double x = turn % 2 == 0 ? p.x + gap : p.x - gap - wide;  // right or left of the point,
      const double y =
          p.y + (turn / 2 % 2 == 0 ? -1 : 1) * (0.35 + turn / 4) * sheet_.textSize;  // above or below
      return Box{x, y - size, x + wide, y + 0.25 * size};
    };
    Box box = at(0);
    for (int turn = 0; turn < 12; ++turn) {
      const Box other = at(turn);
      if (other.right > sheet_.right || other.left < sheet_.left) continue;
      if (std::any_of(taken_.begin(), taken_.end(), [&](const Box& b) { return b.touches(other); })) continue;
      box = other;
      break;
    }
    taken_.push_back(box);
    drawText(image_, box.left, box.top + size, label, {.size = size, .colour = colour});
  }

 private:
  Image& image_;
  const Sheet& sheet_;
  std::vector<Box> taken_;
};

/// Labels beside the ends of their lines, moved apart where they would touch.
void drawLabels(Image& image, const Sheet& s, const Chart& chart) {
  struct Label {
    const ChartLine* line;
    double y;
  };
  std::vector<Label> labels;
  for (const ChartLine& line : chart.lines)
    if (!line.points.empty()) labels.push_back({&line, s.place(line.points.back()).y});
  std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.y < b.y; });
  const double pitch = 1.25 * s.textSize;
  for (int turn = 0; turn < 200; ++turn)
    for (std::size_t i = 1; i < labels.size(); ++i)
      if (const double missing = pitch - (labels[i].y - labels[i - 1].y); missing > 0)
        labels[i - 1].y -= 0.5 * missing, labels[i].y += 0.5 * missing;
  for (const Label& label : labels)
    drawText(image, s.right + 0.8 * s.textSize, label.y + 0.36 * s.textSize, label.line->label,
             {.size = s.textSize, .colour = label.line->colour});
}

}  // namespace

Image drawChart(const Chart& chart) {
  const Annotations words{chart.title, chart.caption, {}};
  Image image(chart.width, chart.height, paper);
  annotate(image, words);
  if (allPoints(chart).empty()) return image;
  const Sheet sheet = makeSheet(chart, words);
  drawAxes(image, sheet, chart);
  for (const ChartLine& line : chart.lines) {
    std::vector<Spot> places;
    for (const Spot& p : line.points) places.push_back(sheet.place(p));
    if (line.dashed) drawDashed(image, places, 2.2, line.colour);
    else if (places.size() > 1) drawStroke(image, places, 2.2, line.colour);
    for (const Spot& p : places) drawDisc(image, p, 3.6, line.colour);
  }
  for (const ChartMark& mark : chart.marks) {
    drawDisc(image, sheet.place(mark.at), 4.4, mark.colour);
    drawDisc(image, sheet.place(mark.at), 2.8, paper);
  }
  PointLabels labels(image, sheet, chart);
  for (const ChartLine& line : chart.lines)
    for (std::size_t i = 0; i < line.pointLabels.size(); ++i)
      labels.add(line.points[i], line.pointLabels[i], line.colour);
  for (const ChartMark& mark : chart.marks) labels.add(mark.at, mark.label, mark.colour);
  drawLabels(image, sheet, chart);
  return image;
}

}  // namespace morula

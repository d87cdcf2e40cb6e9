#include "drawing/axis.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr double manyDecades = 2e3;  // ratio from which ticks are powers of ten only

std::string tickText(double value) { return numberText(value, 6); }

TextStyle tickStyle(double textSize, Anchor anchor) {
  return {.size = smallText * textSize, .colour = quietInk, .anchor = anchor};
}

TextStyle titleStyle(double textSize, bool upward) {
  return {.size = textSize, .colour = quietInk, .anchor = Anchor::centre, .upward = upward};
}

std::vector<double> roundNumbers(double low, double high, int wanted) {
  if (!(high > low) || wanted < 1) return {low};
  const double rough = (high - low) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= rough * (1 - 1e-9)) step = factor * power;
  std::vector<double> ticks;
  const double first = std::ceil(low / step - 1e-9);
  for (int i = 0; (first + i) * step <= high + 1e-9 * (high - low); ++i) ticks.push_back((first + i) * step);
  return ticks;
}

}  // namespace

double Range::shareOf(double value) const { return low < high ? (value - low) / (high - low) : 0; }

void Range::see(double value) { low = std::min(low, value), high = std::max(high, value); }

Range AxisBounds::around(const Range& range, double room) const {
  return {std::min(range.low, clamped(range.low - room)), std::max(range.high, clamped(range.high + room))};
}

double Axis::place(double value) const {
  if (!(low < high)) return from;
  const double share =
      scale == Scale::linear ? (value - low) / (high - low) : std::log(value / low) / std::log(high / low);
  return from + (to - from) * share;
}

std::vector<double> Axis::ticks(int wanted) const {
  if (scale == Scale::linear) return roundNumbers(low, high, wanted);
  std::vector<double> list;
  const double base = scale == Scale::decades ? 10 : 2;
  const bool all = scale == Scale::decades && high / low < manyDecades;
  for (double power = std::floor(std::log(low) / std::log(base)); std::pow(base, power) <= high; ++power)
    for (const double digit : {1.0, 2.0, 5.0})
      if (const double tick = digit * std::pow(base, power); (digit == 1 || all) && tick >= low && tick <= high)
        list.push_back(tick);
  return list;
}

void drawUprightAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title) {
  const double size = frame.textSize;
  const int wanted = std::clamp(int((frame.bottom - frame.top) / (4 * size)), 2, 10);
  for (const double tick : axis.ticks(wanted)) {
    const double y = crisp(axis.place(tick));
    drawing.line({{frame.left, y}, {frame.right, y}}, {.colour = gridInk});
    drawing.text({frame.left - 0.6 * size, y + 0.36 * size}, tickText(tick), tickStyle(size, Anchor::right));
  }
  const double x = crisp(frame.left);
  drawing.line({{x, frame.top}, {x, frame.bottom}}, {.colour = quietInk});
  drawing.text({1.5 * size, 0.5 * (frame.top + frame.bottom)}, title, titleStyle(size, true));
}

void drawLevelAxis(Drawing& drawing, const ChartFrame& frame, const Axis& axis, const std::string& title) {
  const double size = frame.textSize;
  const int wanted = std::clamp(int((frame.right - frame.left) / (5 * size)), 2, 8);
  for (const double tick : axis.ticks(wanted)) {
    const double x = crisp(axis.place(tick));
    drawing.line({{x, frame.top}, {x, frame.bottom}}, {.colour = gridInk});
    drawing.text({x, frame.bottom + 1.4 * size}, tickText(tick), tickStyle(size, Anchor::centre));
  }
  const double y = crisp(frame.bottom);
  drawing.line({{frame.left, y}, {frame.right, y}}, {.colour = quietInk});
  drawing.text({0.5 * (frame.left + frame.right), frame.bottom + 3 * size}, title, titleStyle(size, false));
}

double roomForUprightAxis(const Axis& axis, double textSize) {
  double widest = 0;
  for (const double tick : axis.ticks(10))
    widest = std::max(widest, textWidth(tickText(tick), tickStyle(textSize, Anchor::right)));
  // The room is made up of half a line, the upright title, half a line, the numbers, and their distance to the axis.
  return std::max(4.5 * textSize, 2.6 * textSize + widest);
}

double roomForLevelAxis(double textSize) { return 4 * textSize; }

}  // namespace morula

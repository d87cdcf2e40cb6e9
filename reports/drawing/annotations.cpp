#include "drawing/annotations.h"

#include <algorithm>
#include <cmath>

#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {
namespace {

/// Draws a polygon around `centre`; the points are in units of the radius.
void drawShape(Drawing& drawing, Spot centre, double radius, Colour colour, std::vector<Spot> points) {
  for (Spot& p : points) p = {centre.x + radius * p.x, centre.y + radius * p.y};
  drawing.area(points, colour);
}

/// Returns the outline of a plus: a vertical and a horizontal bar that cross.
std::vector<Spot> bars(double reach, double half) {
  return {{-half, -reach}, {half, -reach}, {half, -half}, {reach, -half}, {reach, half},   {half, half},
          {half, reach},   {-half, reach}, {-half, half}, {-reach, half}, {-reach, -half}, {-half, -half}};
}

struct LegendPlace {
  double x;
  int row;
};

double swatch(double size) { return 0.85 * size; }

std::string legendText(const LegendEntry& entry, double size, double width) {
  return shortened(entry.label, {.size = size}, width - swatch(size) - 0.45 * size);
}

/// Returns the places of the entries, which run from left to right and wrap. x is relative to the legend's left end.
std::vector<LegendPlace> placeLegend(const std::vector<LegendEntry>& legend, double size, double width) {
  std::vector<LegendPlace> places;
  double x = 0;
  int row = 0;
  for (const LegendEntry& entry : legend) {
    const double length = swatch(size) + 0.45 * size + textWidth(legendText(entry, size, width), {.size = size});
    if (x > 0 && x + length > width) x = 0, ++row;
    places.push_back({x, row});
    x += length + 1.3 * size;
  }
  return places;
}

struct Line {
  std::string text;
  TextStyle style;
  double baseline;  // [pixel]
};

constexpr double mostOfHeight = 0.25;  // [1] max height of a band

/// Returns the lines of title and caption: one each where more would need too much of the picture's height.
std::vector<Line> headOf(const Annotations& words, double size, double width, double height, bool breaks = true) {
  const TextStyle title{.size = titleText * size, .colour = ink, .bold = true},
      caption{.size = size, .colour = quietInk};
  std::vector<Line> lines;
  double y = 0.5 * size;
  const auto add = [&](const std::string& text, const TextStyle& style) {
    if (text.empty()) return;
    const double room = width - 3 * size;
    for (std::string& line : breaks ? wrapped(text, style, room) : std::vector{shortened(text, style, room)})
      lines.push_back({std::move(line), style, y += 1.35 * style.size});
    y += 0.3 * size;
  };
  add(words.title, title);
  add(words.caption, caption);
  const bool fits = lines.size() < 2 || lines.back().baseline + size <= mostOfHeight * height;
  return fits || !breaks ? lines : headOf(words, size, width, height, false);
}

/// Returns both numbers with the digits that tell them apart, four at least.
std::pair<std::string, std::string> endTexts(double low, double high) {
  for (int digits = 4; digits < 17; ++digits) {
    const auto a = numberText(low, digits), b = numberText(high, digits);
    if (a != b || low == high) return {a, b};
  }
  return {exactText(low), exactText(high)};
}

}  // namespace

Marker seriesMarker(std::size_t i) {
  constexpr Marker markers[] = {Marker::disc,    Marker::square, Marker::triangle, Marker::diamond,
                                Marker::hanging, Marker::plus,   Marker::ring};
  return markers[i % std::size(markers)];
}

void drawMarker(Drawing& drawing, Spot centre, double radius, Colour colour, Marker marker) {
  const auto shape = [&](const std::vector<Spot>& points) { drawShape(drawing, centre, radius, colour, points); };
  switch (marker) {
    case Marker::disc: return drawing.disc(centre, radius, colour);
    case Marker::square: return shape({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case Marker::triangle: return shape({{0, -1.3}, {1.2, 0.9}, {-1.2, 0.9}});
    case Marker::diamond: return shape({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}});
    case Marker::hanging: return shape({{0, 1.3}, {1.2, -0.9}, {-1.2, -0.9}});
    case Marker::plus: return shape(bars(1.4, 0.45));
    case Marker::ring: drawing.disc(centre, 1.15 * radius, colour); return drawing.disc(centre, 0.6 * radius, paper);
    case Marker::cross: {
      std::vector<Spot> points = bars(1.4, 0.35);
      const double turn = std::sqrt(0.5);
      for (Spot& p : points) p = {turn * (p.x - p.y), turn * (p.x + p.y)};
      return shape(points);
    }
  }
}

double textSizeFor(int width, int height, const Print& print) {
  if (print.textSize > 0) return print.textSize;
  const int side = std::min(width, height);
  return std::clamp(side / 56.0, side < 300 ? 10.0 : 11.0, 40.0);  // in small pictures cells need the room
}

Bands bandsFor(const Annotations& annotations, int width, int height, double textSize) {
  const double size = textSize > 0 ? textSize : textSizeFor(width, height);
  const auto head = headOf(annotations, size, width, height);
  double top = head.empty() ? 0 : head.back().baseline + size, bottom = 0;
  if (!annotations.legend.empty()) {
    const auto places = placeLegend(annotations.legend, size, width - 3 * size);
    bottom = (places.back().row + 1) * 1.6 * size + 1.2 * size;
  }
  return {int(std::min(top, mostOfHeight * height)), int(std::min(bottom, mostOfHeight * height))};
}

Bands bandsAround(int middle, const Annotations& annotations, int width, double textSize) {
  Bands bands{middle, middle};  // iterated, because each band is at most a quarter of the whole height
  for (int i = 0; i < 16; ++i) bands = bandsFor(annotations, width, middle + bands.top + bands.bottom, textSize);
  return bands;
}

void annotate(Drawing& drawing, const Annotations& annotations, double textSize) {
  const double size = textSize > 0 ? textSize : textSizeFor(drawing.width(), drawing.height()), left = 1.5 * size;
  const Bands bands = bandsFor(annotations, drawing.width(), drawing.height(), size);
  const double room = drawing.width() - 2 * left;
  for (const Line& line : headOf(annotations, size, drawing.width(), drawing.height()))
    drawing.text({left, line.baseline}, line.text, line.style);
  const auto places = placeLegend(annotations.legend, size, room);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const LegendEntry& entry = annotations.legend[i];
    if (!entry.shown) continue;
    const double x = left + places[i].x;
    const double baseline = drawing.height() - bands.bottom + (places[i].row + 1) * 1.6 * size;
    if (baseline > drawing.height()) break;
    if (entry.marker == Marker::square)
      drawing.box({x, baseline - 0.78 * size}, swatch(size), swatch(size), entry.colour);
    else drawMarker(drawing, {x + 0.5 * swatch(size), baseline - 0.36 * size}, 0.38 * size, entry.colour, entry.marker);
    drawing.text({x + swatch(size) + 0.45 * size, baseline}, legendText(entry, size, room),
                 {.size = size, .colour = quietInk});
  }
}

void drawColourBar(Drawing& drawing, const ColourBar& bar, Spot at, double width, double textSize) {
  if (bar.blank) return;
  const TextStyle title{.size = textSize, .colour = quietInk};
  drawing.text({at.x, at.y + textSize}, shortened(bar.title, title, drawing.width() - at.x - 0.5 * textSize), title);
  const double top = at.y + 1.5 * textSize, height = 0.9 * textSize;
  const int steps = std::max(2, int(width));
  // Each box reaches to the bar's end, so that no edges shine through between neighbours.
  for (int i = 0; i < steps; ++i) {
    const double from = width * i / steps;
    const double share = bar.low < bar.high ? double(i) / (steps - 1) : 0;
    drawing.box({at.x + from, top}, width - from, height, scaleColour(share));
  }
  TextStyle number{.size = smallText * textSize, .colour = quietInk};
  const double baseline = top + height + 1.15 * textSize;
  const auto [low, high] = endTexts(bar.low, bar.high);
  drawing.text({at.x, baseline}, low, number);
  number.anchor = Anchor::right;
  if (bar.low < bar.high) drawing.text({at.x + width, baseline}, high, number);
}

double colourBarHeight(double textSize) { return 4.0 * textSize; }

}  // namespace morula

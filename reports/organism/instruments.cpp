#include "organism/instruments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {
namespace {

enum class Kind { axes, colourBar, arrowKey, scaleBar };

/// An instrument's box in the band; places are relative to the band's upper left corner.
struct Place {
  Kind kind;
  double x, y, width;
};

struct Layout {
  std::vector<Place> places;
  double height = 0;
};

constexpr double rowHeight = 5.2, gap = 2.0;  // [text size]

/// Places instruments from left to right, and in a further row if there is no room left.
Layout layOut(const Instruments& instruments, double width, double textSize) {
  const double margin = 1.5 * textSize, room = std::max(1.0, width - 2 * margin);
  const double bar = std::min(room, std::max(9 * textSize, 0.3 * width));
  const double ruler = std::min(room, std::max(8 * textSize, 0.2 * width));
  Layout layout;
  double x = 0, y = 0;
  const auto add = [&](bool wanted, Kind kind, double wide) {
    if (!wanted) return;
    if (x > 0 && x + wide > room) x = 0, y += rowHeight * textSize;
    layout.places.push_back({kind, margin + x, y, wide});
    x += wide + gap * textSize;
    layout.height = y + rowHeight * textSize;
  };
  add(instruments.axes, Kind::axes, 5 * textSize);
  add(instruments.colourBar.has_value(), Kind::colourBar, bar);
  add(instruments.arrowKey.has_value(), Kind::arrowKey, ruler);
  add(instruments.scaleBar, Kind::scaleBar, ruler);
  return layout;
}

void drawAxes(Drawing& drawing, const PictureScale& eye, Spot middle, double textSize) {
  constexpr std::array names{"x", "y", "z"};
  const std::array directions{Spot{eye.x.x, -eye.y.x}, Spot{eye.x.y, -eye.y.y}, Spot{eye.x.z, -eye.y.z}};
  const std::array depths{eye.z.x, eye.z.y, eye.z.z};
  const double length = 1.3 * textSize;
  std::array<int, 3> order{0, 1, 2};  // from the farthest to the nearest
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return depths[a] < depths[b]; });
  for (const int i : order) {
    const Colour colour = seriesColour(std::array{1, 2, 0}[i]);
    Spot way = directions[i];
    const double seen = std::hypot(way.x, way.y);
    const Spot tip{middle.x + length * way.x, middle.y + length * way.y};
    drawing.line({middle, tip}, {.width = std::max(1.5, 0.13 * textSize), .colour = colour});
    // An axis along the line of sight is a point: its letter is placed away from the other two.
    if (seen < 0.3) {
      Spot sum;
      for (int k = 0; k < 3; ++k)
        if (k != i) sum.x += directions[k].x, sum.y += directions[k].y;
      const double size = std::hypot(sum.x, sum.y);
      way = size > 1e-9 ? Spot{-0.35 * sum.x / size, -0.35 * sum.y / size} : Spot{-0.25, 0.25};
      drawing.disc(middle, 0.2 * textSize, colour);
    }
    const double size = std::hypot(way.x, way.y), reach = length * std::max(seen, size) + 0.6 * textSize;
    drawing.text({middle.x + reach * way.x / size, middle.y + reach * way.y / size + 0.33 * textSize}, names[i],
                 {.size = textSize, .colour = colour, .bold = true, .anchor = Anchor::centre});
  }
}

/// Draws a bar or an arrow of a round number of units with the number above.
void drawRuler(Drawing& drawing, Spot at, double width, double pixelsPerUnit, const std::string& unit, Colour colour,
               bool arrow, double textSize) {
  const double value = roundBelow(width / pixelsPerUnit), length = value * pixelsPerUnit;
  const TextStyle style{.size = textSize, .colour = quietInk};
  drawing.text({at.x, at.y + 1.4 * textSize}, shortened(numberText(value, 3) + " " + unit, style, width), style);
  const double y = at.y + 2.3 * textSize, thick = std::max(2.0, std::round(0.25 * textSize));
  if (!arrow) return drawing.box({std::round(at.x), std::round(y)}, length, thick, colour);
  const double head = std::min(0.9 * textSize, 0.5 * length);
  drawing.line({{at.x, y}, {at.x + length, y}}, {.width = 0.6 * thick, .colour = colour});
  for (const double side : {-1.0, 1.0})
    drawing.line({{at.x + length, y}, {at.x + length - head, y + side * 0.5 * head}},
                 {.width = 0.6 * thick, .colour = colour});
}

}  // namespace

double roundBelow(double most) {
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {10.0, 5.0, 2.0, 1.0})
    if (factor * power <= most * (1 + 1e-12)) return factor * power;
  return power;
}

int instrumentsHeight(const Instruments& instruments, int width, double textSize) {
  if (!instruments.any()) return 0;
  return int(std::ceil(layOut(instruments, width, textSize).height + 0.6 * textSize));
}

void drawInstruments(Drawing& drawing, const Instruments& instruments, const PictureScale& scale, double top,
                     double textSize) {
  if (!instruments.any()) return;
  for (const Place& place : layOut(instruments, drawing.width(), textSize).places) {
    const Spot at{place.x, top + place.y};
    switch (place.kind) {
      case Kind::axes: drawAxes(drawing, scale, {at.x + 0.5 * place.width, at.y + 2.6 * textSize}, textSize); break;
      case Kind::colourBar: drawColourBar(drawing, *instruments.colourBar, at, place.width, textSize); break;
      case Kind::arrowKey:
        drawRuler(drawing, at, place.width, instruments.arrowKey->lengthPerUnit * scale.pixelsPerLength,
                  instruments.arrowKey->unit, instruments.arrowKey->colour, true, textSize);
        break;
      case Kind::scaleBar:
        drawRuler(drawing, at, place.width, scale.pixelsPerLength / instruments.perLength, instruments.lengthUnit, ink,
                  false, textSize);
    }
  }
}

}  // namespace morula

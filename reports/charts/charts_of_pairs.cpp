#include "charts/charts_of_pairs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "drawing/annotations.h"
#include "drawing/axis.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr double minText = 6;    // [pixel] smaller letters are illegible
constexpr double minFramed = 5;  // [pixel] a frame around a smaller square would hide its colour

struct Circle {
  Spot middle;
  double radius;  // [pixel]
  Spot at(double degrees, double share) const {
    const double angle = degrees * std::numbers::pi / 180;
    return {middle.x + share * radius * std::cos(angle), middle.y - share * radius * std::sin(angle)};
  }
};

/// Returns points along the arc between two directions [degree], at this share of the radius.
std::vector<Spot> arc(const Circle& circle, double from, double to, double share) {
  std::vector<Spot> points;
  const int steps = std::max(2, int(std::ceil((to - from) / 3)));
  for (int i = 0; i <= steps; ++i) points.push_back(circle.at(from + (to - from) * i / steps, share));
  return points;
}

void drawRose(Drawing& drawing, const Rose& rose, const Circle& circle, const std::vector<int>& counts, int most,
              double size) {
  for (const double share : {0.5, 1.0}) drawing.line(arc(circle, 0, 360, share), {.colour = gridInk});
  for (const double degrees : {0.0, 90.0})
    drawing.line({circle.at(degrees, 1), circle.at(degrees + 180, 1)}, {.colour = gridInk});
  const double wide = 360.0 / double(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    std::vector<Spot> wedge =
        arc(circle, (double(i) - 0.46) * wide, (double(i) + 0.46) * wide, std::sqrt(double(counts[i]) / most));
    wedge.push_back(circle.middle);
    drawing.area(wedge, seriesColour(0));
  }
  const TextStyle plain{.size = size, .colour = quietInk, .anchor = Anchor::centre};
  const Spot right = circle.at(0, 1), up = circle.at(90, 1);
  drawing.text({right.x + 0.9 * size, right.y + 0.36 * size}, rose.right, plain);
  drawing.text({up.x, up.y - 0.5 * size}, rose.up, plain);
  const Spot ring = circle.at(45, 1);
  if (most > 0)
    drawing.text({ring.x + 0.3 * size, ring.y - 0.2 * size}, std::to_string(most),
                 {.size = smallText * size, .colour = quietInk});
  TextStyle title = plain;
  title.colour = ink;
  drawing.text({circle.middle.x, circle.middle.y + circle.radius + 2.2 * size},
               rose.title + ": " + std::to_string(rose.degrees.size()), title);
}

}  // namespace

Drawing drawMatrix(const MatrixPicture& asked) {
  MatrixPicture picture = asked;
  const std::size_t n = picture.names.size();
  if (picture.values.size() != n * n)
    throw InputError("a matrix of " + std::to_string(n) + " names needs " + std::to_string(n * n) + " values, not " +
                     std::to_string(picture.values.size()));
  if (picture.width == 0) picture.width = int(std::clamp(260.0 + 14.0 * double(n), 800.0, 2400.0));
  if (picture.height == 0) picture.height = picture.width + int(std::max(120.0, 12 * picture.print.textSize));
  Drawing drawing(picture.width, picture.height, Drawing::Ground::paper, picture.print);
  const Annotations words{picture.title, picture.caption, {}};
  const Annotations unnamed{picture.title, picture.caption + "; the names need a larger picture", {}};
  const double size = textSizeFor(picture.width, picture.height, picture.print);
  const double bar = colourBarHeight(size) + 2 * size, top = bandsFor(unnamed, picture.width, picture.height, size).top;
  const double most = std::min(picture.width - 3 * size, picture.height - top - bar - size);
  // Letters are at most 0.8 of a row high. Names take part of the square, which lowers the rows: hence two turns.
  double text = std::min(size, 0.8 * most / double(n)), room = 0;
  for (int turn = 0; turn < 2; ++turn) {
    room = 0;
    for (const std::string& name : picture.names) room = std::max(room, textWidth(name, {.size = text}));
    room = std::min(room, 0.3 * most);
    text = std::min(size, 0.8 * (most - room) / double(n));
  }
  const bool named = text >= (picture.print.onPaper() ? smallText * size : minText);
  annotate(drawing, named ? words : unnamed, size);
  if (n == 0) return drawing;
  const double edge = named ? room + 0.6 * text : 0, side = (most - edge) / double(n);
  const Spot corner{0.5 * (picture.width - most) + edge, top + edge};
  Range range;
  for (const auto& value : picture.values)
    if (value) range.see(*value);
  drawing.area({corner,
                {corner.x + side * double(n), corner.y},
                {corner.x + side * double(n), corner.y + side * double(n)},
                {corner.x, corner.y + side * double(n)}},
               {0xf0, 0xf0, 0xec});
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column)
      if (const auto& value = picture.values[row * n + column]) {
        // A frame and a gap tell values from the ground, which in grey is as light as the brightest colours.
        const double gap = side >= minFramed ? 0.06 * side : 0, own = side - 2 * gap;
        const double x = corner.x + side * double(column) + gap, y = corner.y + side * double(row) + gap;
        drawing.box({x, y}, own, own, scaleColour(range.shareOf(*value)));
        if (side >= minFramed)
          drawing.line({{x, y}, {x + own, y}, {x + own, y + own}, {x, y + own}, {x, y}},
                       {.width = side < 12 ? 0.5 : 1, .colour = quietInk});
      }
  for (std::size_t i = 0; named && i < n; ++i) {
    const double middle = side * (double(i) + 0.5) + 0.36 * text;
    TextStyle style{.size = text, .colour = ink, .anchor = Anchor::right};
    const std::string name = shortened(picture.names[i], style, room);
    drawing.text({corner.x - 0.4 * text, corner.y + middle}, name, style);
    style.anchor = Anchor::left, style.upward = true;
    drawing.text({corner.x + middle, corner.y - 0.4 * text}, name, style);
  }
  if (range.low <= range.high)
    drawColourBar(drawing, {picture.quantity, range.low, range.high}, {1.5 * size, picture.height - bar + size},
                  std::min(picture.width - 3 * size, 24 * size), size);
  return drawing;
}

std::vector<int> countSectors(const std::vector<double>& degrees, int sectors) {
  std::vector<int> counts(sectors);
  for (const double direction : degrees) {
    const double turns = direction / 360;
    const double share = turns - std::floor(turns);  // 0 to 1
    ++counts[std::size_t(std::lround(share * sectors)) % std::size_t(sectors)];
  }
  return counts;
}

Drawing drawRoses(const RosePicture& asked) {
  RosePicture picture = asked;
  if (picture.sectors < 4 || picture.sectors > 360)
    throw InputError("a rose cannot have " + std::to_string(picture.sectors) + " sectors; it must have 4 to 360");
  for (const Rose& rose : picture.roses)
    for (const double direction : rose.degrees)
      if (!std::isfinite(direction)) throw InputError("a direction of a rose is not finite");
  const Annotations words{picture.title, picture.caption, {}};
  const double size = std::max(11.0, textSizeFor(picture.width, std::max(picture.height, 1), picture.print));
  const int count = std::max(1, int(picture.roses.size()));
  const int columns = std::clamp(int(picture.width / (14 * size)), 1, count), rows = (count + columns - 1) / columns;
  const double each = double(picture.width) / columns;
  if (picture.height == 0) {
    const Bands bands = bandsAround(int(rows * each), words, picture.width, size);
    picture.height = int(rows * each) + bands.top + bands.bottom;
  }
  Drawing drawing(picture.width, picture.height, Drawing::Ground::paper, picture.print);
  annotate(drawing, words, picture.print.textSize);
  if (picture.roses.empty()) return drawing;
  const double top = bandsFor(words, picture.width, picture.height, picture.print.textSize).top;
  const double high = (picture.height - top) / rows,
               radius = std::max(8.0, 0.5 * (std::min(high, each + 0.8 * size) - 5.2 * size));
  int most = 0;
  std::vector<std::vector<int>> counts;
  for (const Rose& rose : picture.roses) {
    counts.push_back(countSectors(rose.degrees, picture.sectors));
    most = std::max(most, *std::max_element(counts.back().begin(), counts.back().end()));
  }
  for (std::size_t i = 0; i < picture.roses.size(); ++i)
    drawRose(
        drawing, picture.roses[i],
        {{each * (double(i % columns) + 0.5), top + high * double(i / columns) + 0.5 * (high - 1.6 * size)}, radius},
        counts[i], most, size);
  return drawing;
}

}  // namespace morula

#include "charts/matrix.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "drawing/annotations.h"
#include "drawing/axis.h"
#include "drawing/colour_bar.h"
#include "drawing/palette.h"

namespace morula {
namespace {

constexpr double leastText = 6;    // [pixel] smaller letters cannot be read
constexpr double leastFramed = 5;  // [pixel] a frame around less would hide the colour

}  // namespace

Drawing drawMatrix(const MatrixPicture& asked) {
  MatrixPicture picture = asked;
  const std::size_t n = picture.names.size();
  if (picture.values.size() != n * n)
    throw InputError("a matrix of " + std::to_string(n) + " names needs " + std::to_string(n * n) + " values, not " +
                     std::to_string(picture.values.size()));
  if (picture.width == 0) picture.width = int(std::clamp(260.0 + 14.0 * double(n), 800.0, 2400.0));
  if (picture.height == 0) picture.height = picture.width + 120;
  Drawing drawing(picture.width, picture.height);
  const Annotations words{picture.title, picture.caption, {}};
  annotate(drawing, words);
  if (n == 0) return drawing;
  const double size = textSizeFor(picture.width, picture.height);
  const double bar = colourBarHeight(size) + 2 * size, top = bandsFor(words, picture.width, picture.height).top;
  const double most = std::min(picture.width - 3 * size, picture.height - top - bar - size);
  // Names take a part of the square; their letters are as high as a row.
  double text = std::min(size, 0.8 * most / double(n)), room = 0;
  for (int turn = 0; turn < 2; ++turn) {
    room = 0;
    for (const std::string& name : picture.names) room = std::max(room, textWidth(name, {.size = text}));
    room = std::min(room, 0.3 * most);
    text = std::min(size, 0.8 * (most - room) / double(n));
  }
  const bool named = text >= leastText;
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
        // In grey the scale's brightest colours are as light as the ground: what is there has a frame, and a gap around it.
        const double gap = side >= leastFramed ? 0.06 * side : 0, own = side - 2 * gap;
        const double x = corner.x + side * double(column) + gap, y = corner.y + side * double(row) + gap;
        drawing.box({x, y}, own, own,
                    scaleColour(range.low < range.high ? (*value - range.low) / (range.high - range.low) : 0));
        if (side >= leastFramed)
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

}  // namespace morula

#include "drawing/colour_bar.h"

#include <algorithm>

#include "base/number_text.h"
#include "drawing/palette.h"

namespace morula {
namespace {

/// Both with as many digits as it takes to tell them apart, four at least.
std::pair<std::string, std::string> endTexts(double low, double high) {
  for (int digits = 4; digits < 17; ++digits) {
    const auto a = numberText(low, digits), b = numberText(high, digits);
    if (a != b || low == high) return {a, b};
  }
  return {exactText(low), exactText(high)};
}

}  // namespace

void drawColourBar(Drawing& drawing, const ColourBar& bar, Spot at, double width, double textSize) {
  if (bar.blank) return;
  const TextStyle title{.size = textSize, .colour = quietInk};
  drawing.text({at.x, at.y + textSize}, shortened(bar.title, title, width), title);
  const double top = at.y + 1.5 * textSize, height = 0.9 * textSize;
  const int steps = std::max(2, int(width));
  // Each box reaches to the bar's end, so that no edges shine through between two of them.
  for (int i = 0; i < steps; ++i) {
    const double from = width * i / steps;
    const double share = bar.low < bar.high ? double(i) / (steps - 1) : 0;
    drawing.box({at.x + from, top}, width - from, height, scaleColour(share));
  }
  TextStyle number{.size = 0.9 * textSize, .colour = quietInk};
  const double baseline = top + height + 1.15 * textSize;
  const auto [low, high] = endTexts(bar.low, bar.high);
  drawing.text({at.x, baseline}, low, number);
  number.anchor = Anchor::right;
  if (bar.low < bar.high) drawing.text({at.x + width, baseline}, high, number);
}

double colourBarHeight(double textSize) { return 4.0 * textSize; }

}  // namespace morula

#include "drawing/canvas.h"

#include <algorithm>
#include <cmath>

namespace morula {
namespace {

double distanceToSegment(Spot p, Spot a, Spot b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
  const double along =
      length2 > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length2, 0.0, 1.0) : 0;
  const double x = p.x - a.x - along * dx, y = p.y - a.y - along * dy;
  return std::sqrt(x * x + y * y);
}

void blend(Colour& under, Colour over, double cover) {
  const auto mix = [cover](std::uint8_t a, std::uint8_t b) {
    return std::uint8_t(a + (b - a) * cover + 0.5);
  };
  under = {mix(under.r, over.r), mix(under.g, over.g), mix(under.b, over.b)};
}

/// The pixels that something reaching `reach` around a box may touch.
struct Reach {
  int left, top, right, bottom;
  Reach(const Image& image, Spot low, Spot high, double reach)
      : left(std::max(0, int(std::floor(low.x - reach)))),
        top(std::max(0, int(std::floor(low.y - reach)))),
        right(std::min(image.width, int(std::ceil(high.x + reach)))),
        bottom(std::min(image.height, int(std::ceil(high.y + reach)))) {}
  bool empty() const { return left >= right || top >= bottom; }
};

}  // namespace

void drawStroke(Image& image, const std::vector<Spot>& points, double width, Colour colour) {
  if (points.empty() || !(width > 0)) return;
  Spot low = points.front(), high = low;
  for (const Spot& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double reach = 0.5 * width + 1;
  const Reach all(image, low, high, reach);
  if (all.empty()) return;
  // Gathered first and blended once, so that joints do not come out darker.
  const int columns = all.right - all.left;
  std::vector<float> cover(std::size_t(columns) * (all.bottom - all.top));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Spot a = points[i], b = points[std::min(i + 1, points.size() - 1)];
    const Reach part(image, {std::min(a.x, b.x), std::min(a.y, b.y)},
                     {std::max(a.x, b.x), std::max(a.y, b.y)}, reach);
    for (int y = part.top; y < part.bottom; ++y)
      for (int x = part.left; x < part.right; ++x) {
        // Lines thinner than a pixel cover that share of it, and no more.
        const double away = distanceToSegment({x + 0.5, y + 0.5}, a, b);
        const double share = std::min({1.0, width, std::max(0.0, 0.5 * width + 0.5 - away)});
        float& here = cover[std::size_t(y - all.top) * columns + (x - all.left)];
        here = std::max(here, float(share));
      }
  }
  for (int y = all.top; y < all.bottom; ++y)
    for (int x = all.left; x < all.right; ++x) {
      const float share = cover[std::size_t(y - all.top) * columns + (x - all.left)];
      if (share > 0) blend(image.at(x, y), colour, share);
    }
}

void drawDisc(Image& image, Spot centre, double radius, Colour colour) {
  drawStroke(image, {centre}, 2 * radius, colour);
}

}  // namespace morula

#pragma once
// The surfaces that a drawing's marks are drawn onto: cairo's, and an SVG file.
#include "drawing/drawing.h"

namespace morula {

class Canvas {
 public:
  virtual ~Canvas() = default;
  // Each member is as that of Drawing with its name; lines and areas have at least one point.
  virtual void line(const std::vector<Spot>& points, const Stroke& stroke) = 0;
  virtual void disc(Spot centre, double radius, Colour colour) = 0;
  virtual void area(const std::vector<Spot>& points, Colour colour) = 0;
  virtual void box(Spot topLeft, double width, double height, Colour colour) = 0;
  virtual void text(Spot baseline, const std::string& text, const TextStyle& style) = 0;
  virtual void image(Spot topLeft, const Image& image, double pixel) = 0;
};

/// An SVG file with words as text.
class SvgFile : public Canvas {
 public:
  /// Begins a file of this size [pixel], which is `print.pixel` times as many points.
  SvgFile(int width, int height, const Print& print);

  void line(const std::vector<Spot>& points, const Stroke& stroke) override;
  void disc(Spot centre, double radius, Colour colour) override;
  void area(const std::vector<Spot>& points, Colour colour) override;
  void box(Spot topLeft, double width, double height, Colour colour) override;
  void text(Spot baseline, const std::string& text, const TextStyle& style) override;
  void image(Spot topLeft, const Image& image, double pixel) override;

  /// Ends the file and returns its bytes.
  std::string finish() { return std::move(bytes_) + "</g>\n</svg>\n"; }

 private:
  std::string bytes_;
};

/// Lengths [pixel] that a dashed line is drawn and blank.
inline constexpr double dashes[] = {9, 6};

/// A path from point to point with rounded corners: `moveTo(a)`, `lineTo(a)`, and `curveTo(a, b, c)` with control
/// points a and b.
template <class Path>
void trace(Path& path, const std::vector<Spot>& points, double rounding) {
  constexpr double quarterCircle = 0.5523;  // control points stand at this share of the way to the corner
  const auto between = [](Spot a, Spot b, double share) {
    return Spot{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  };
  const auto before = [&](Spot corner, Spot other) {
    const double length = std::hypot(other.x - corner.x, other.y - corner.y);
    return between(corner, other, length > 0 ? std::min(0.5, rounding / length) : 0);
  };
  path.moveTo(points.front());
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const Spot corner = points[i], from = before(corner, points[i - 1]), to = before(corner, points[i + 1]);
    path.lineTo(from);
    if (rounding > 0) path.curveTo(between(from, corner, quarterCircle), between(to, corner, quarterCircle), to);
  }
  path.lineTo(points.back());
}

}  // namespace morula

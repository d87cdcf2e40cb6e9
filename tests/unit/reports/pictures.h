#pragma once
// Small pictures that several tests draw, and properties of the result.
#include <algorithm>

#include "drawing/drawing.h"
#include "mesh/mesh.h"
#include "organism/organism.h"

namespace morula {

inline constexpr Colour red{0xe0, 0x20, 0x20}, blue{0x20, 0x40, 0xe0};

inline CellShape ball(const char* path, Point centre, double radius, Colour colour) {
  CellShape cell{.path = path, .vertices = {}, .colour = colour};
  for (const Point& p : makeIcosphere(2).vertices) cell.vertices.push_back(centre + p * radius);
  return cell;
}

/// Returns a picture seen from +z with y up, 3.8 units wide at its centre: a ball of radius 1 fills about half.
inline OrganismPicture picture(std::vector<CellShape> cells, int side = 120) {
  OrganismPicture result;
  result.faces = makeIcosphere(2).faces;
  result.cells = std::move(cells);
  result.camera = {.towardsEye = {0, 0, 1}, .up = {0, 1, 0}, .framing = Framing{{0, 0, 0}, 10}};
  result.width = result.height = side;
  return result;
}

inline bool isReddish(Colour c) { return c.r > 100 && c.r > 2 * c.g && c.r > 2 * c.b; }
inline bool isBluish(Colour c) { return c.b > 100 && c.b > 2 * c.r; }
inline int brightness(Colour c) { return c.r + c.g + c.b; }

inline Colour centre(const Image& image) { return image.at(image.width / 2, image.height / 2); }

template <class Kind>
int countPixels(const Image& image, Kind kind) {
  return static_cast<int>(std::ranges::count_if(image.pixels, kind));
}

inline int countPixels(const Image& image, Colour colour) {
  return countPixels(image, [&](Colour c) { return c == colour; });
}

inline int countPixels(const Drawing& drawing, Colour colour) { return countPixels(drawing.pixels(), colour); }

inline bool isInk(Colour c) { return c != paper; }

inline Image part(const Image& image, int left, int top, int width, int height) {
  Image result(width, height, {});
  for (int y = 0; y < height; ++y) std::copy_n(&image.at(left, top + y), width, &result.at(0, y));
  return result;
}

/// The first and last column and row with pixels of a kind.
struct Extent {
  int left, right = -1, top, bottom = -1;
};

template <class Kind>
Extent extentOf(const Image& image, Kind kind) {
  Extent e{.left = image.width, .top = image.height};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (kind(image.at(x, y)))
        e = {std::min(e.left, x), std::max(e.right, x), std::min(e.top, y), std::max(e.bottom, y)};
  return e;
}

inline bool touchesEdges(const Image& image) {
  const Extent e = extentOf(image, isInk);
  return e.left == 0 || e.top == 0 || e.right == image.width - 1 || e.bottom == image.height - 1;
}

/// Returns the largest difference of a channel.
inline int apart(Colour a, Colour b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

}  // namespace morula

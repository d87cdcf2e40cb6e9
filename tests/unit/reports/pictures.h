#pragma once
// Small pictures that several tests draw, and how they look at the result.
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

/// Seen from +z with y up, centred, 3.8 units wide at the centre: a ball of radius 1 fills about half.
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

inline int countPixels(const Drawing& drawing, Colour colour) {
  const Image image = drawing.pixels();
  return static_cast<int>(std::count(image.pixels.begin(), image.pixels.end(), colour));
}

}  // namespace morula

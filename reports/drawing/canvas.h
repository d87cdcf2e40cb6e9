#pragma once
// Lines and dots on an image, smoothed at their edges by how much of a pixel they cover. Plain arithmetic, so
// equal drawings have equal pixels. Coordinates in pixels from the top left corner; pixel (0, 0) covers 0
// to 1.
#include <vector>

#include "image/image.h"

namespace morula {

struct Spot {
  double x = 0, y = 0;
};

/// A line through the points with round ends and joints. Where it meets itself it is not darker.
void drawStroke(Image& image, const std::vector<Spot>& points, double width, Colour colour);

void drawDisc(Image& image, Spot centre, double radius, Colour colour);

}  // namespace morula

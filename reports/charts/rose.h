#pragma once
// Directions in a plane, counted by sectors.
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct Rose {
  std::string title;            // UTF-8
  std::string right, up;        // what the directions at 0° and 90° are called
  std::vector<double> degrees;  // counter-clockwise from `right`; any turn
};

struct RosePicture {
  std::string title, caption;
  std::vector<Rose> roses;         // side by side
  int sectors = 24;                // of each, 4 to 360; the first one's middle is at 0°
  int width = 1200, height = 560;  // [pixel]
};

/// How many directions lie in each sector.
std::vector<int> countSectors(const std::vector<double>& degrees, int sectors);

/// A sector's area grows as its count, on one scale in all roses: a circle marks the greatest count, and one with half
/// of the radius a quarter of it. Throws InputError for sectors out of range and directions that are not finite.
Drawing drawRoses(const RosePicture& picture);

}  // namespace morula

#pragma once
// A quantity of pairs as a table of colours, and directions in a plane, counted by sectors.
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct MatrixPicture {
  std::string title, caption;
  std::vector<std::string> names;             // of rows and columns alike, UTF-8
  std::vector<std::optional<double>> values;  // [row · names + column]; absent: paper
  std::string quantity;                       // with its unit
  int width = 0, height = 0;                  // [pixel] 0: what suits the number of names
};

/// The least and the greatest value are the ends of the colour bar below. Names stand at rows and columns where there
/// is room for letters. Throws InputError if there is not one value for each place.
Drawing drawMatrix(const MatrixPicture& picture);

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

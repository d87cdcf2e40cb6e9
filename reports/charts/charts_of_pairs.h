#pragma once
// Charts of pairs: a quantity as a table of colours, and directions in a plane, counted by sectors.
#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.h"

namespace morula {

struct MatrixPicture {
  std::string title, caption;
  std::vector<std::string> names;             // UTF-8; rows and columns have the same names
  std::vector<std::optional<double>> values;  // [row · names + column]; absent values show paper
  std::string quantity;                       // with its unit
  int width = 0, height = 0;                  // [pixel] 0: chosen by the number of names
  Print print = {};
};

/// Draws the table above a colour bar from its least to its greatest value. Names are written if there is room for
/// letters, and the caption says if there is not. Throws InputError unless there is one value for each place.
Drawing drawMatrix(const MatrixPicture& picture);

struct Rose {
  std::string title;            // UTF-8
  std::string right, up;        // names of the directions at 0° and 90°
  std::vector<double> degrees;  // counter-clockwise from `right`; any turn
};

struct RosePicture {
  std::string title, caption;
  std::vector<Rose> roses;         // side by side, as many as have room
  int sectors = 24;                // sectors of a rose, 4 to 360; the first is centred on 0°
  int width = 1200, height = 560;  // [pixel] height 0: what suits
  Print print = {};
};

/// Returns the number of directions in each sector.
std::vector<int> countSectors(const std::vector<double>& degrees, int sectors);

/// Draws roses whose sectors have areas in proportion to their counts, on one scale for all. A circle marks the
/// greatest count, one of half its radius a quarter of it. Throws InputError for sectors out of range and directions
/// that are not finite.
Drawing drawRoses(const RosePicture& picture);

}  // namespace morula

#pragma once
// A quantity of pairs, as a table of colours.
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

/// The least and the greatest value are the ends of the colour bar below. Names stand at rows and columns where there is
/// room for letters. Throws InputError if there is not one value for each place.
Drawing drawMatrix(const MatrixPicture& picture);

}  // namespace morula

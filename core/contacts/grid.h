#pragma once
// A uniform grid over the bounding box of all vertices. Bins along x stand side by side, so that the 27 bins
// around a vertex are nine rows.
#include "contacts/point_table.h"

namespace morula {

struct GridSearch {
  Point low;              // corner of bin 0
  double inverseBin = 0;  // [1/length]
  int nx = 0, ny = 0, nz = 0;
  std::vector<std::int32_t> start;  // [bin + 1] into points
  PointTable points;
  std::vector<std::int32_t> binOf;  // scratch

  /// Returns the number of a bin along one axis. Everything outside, and NaN, belongs to a bin at the border.
  int column(double a, double lowest, int n) const {
    const double i = (a - lowest) * inverseBin;
    return i >= n ? n - 1 : i > 0 ? static_cast<int>(i) : 0;
  }
};

void prepare(GridSearch& grid, const SearchInput& input);
void searchBlock(const GridSearch& grid, const SearchInput& input, int block, BlockLists& lists);

}  // namespace morula

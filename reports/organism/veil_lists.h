#pragma once
// Translucent surfaces as lists, one for each sample, and what one sees through them.
#include <cstdint>
#include <vector>

namespace morula {

/// A translucent surface that a sample meets, as the cells' shader writes it.
struct VeilFragment {
  float depth;             // in the picture: 0 near to 1 far
  std::uint32_t owner;     // the cell's number, from 1
  std::uint16_t light[3];  // linear light; 65535 is 2
  std::uint16_t opacity;   // 65535 is 1
};
static_assert(sizeof(VeilFragment) == 16);

/// The lists of some neighbouring rows of the sample grid, row by row.
struct VeilRows {
  int width = 0, rows = 0;
  VeilFragment* fragments = nullptr;
  const std::uint32_t* ends =
      nullptr;  // list i ends before fragment ends[i], and begins where list i − 1 ends; 0: at 0
};

/// Brings each list in order: from the eye on, at the same depth by owner, whatever the order was before.
void sortVeils(const VeilRows& veils, int threads);

/// Light and opacity of what each sample of rows `first` to `last` − 1 sees through, each surface under those before it
/// [Porter & Duff 1984]; four numbers a sample, the light multiplied by its opacity; 0 where there is nothing. Cells
/// have dark outlines: where the surface in the same place of a neighbour's list, `outlineReach` samples away, is
/// another cell's. Rows beyond these must be there as far as neighbours reach, except at the grid's own border.
/// The lists are sorted.
std::vector<float> composeVeils(const VeilRows& veils, int first, int last, int outlineReach, int threads);

}  // namespace morula

#pragma once
// Lists of the translucent surfaces at each sample, and their compositing.
#include <cstdint>
#include <vector>

namespace morula {

/// A translucent surface at a sample, as the cells' shader writes it.
struct VeilFragment {
  float depth;             // 0 near to 1 far
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
      nullptr;  // list i ends before fragment ends[i], and begins where list i − 1 ends; list 0 begins at 0
};

/// Sorts each list by depth from the eye on, then by owner; the result does not depend on the order before.
void sortVeils(const VeilRows& veils, int threads);

/// Returns light and opacity seen at each sample of rows `first` to `last` − 1, by compositing the sorted lists [Porter
/// & Duff 1984]. Each sample has four numbers, the light multiplied by its opacity; 0 without surfaces. Cells have dark
/// outlines where a neighbour's list, `outlineReach` samples away, has another cell at the same position. Neighbouring
/// rows must be in `veils`, except beyond the grid's border.
std::vector<float> composeVeils(const VeilRows& veils, int first, int last, int outlineReach, int threads);

}  // namespace morula

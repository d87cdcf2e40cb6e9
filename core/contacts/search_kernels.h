#pragma once
// The innermost loops of the neighbour search, one table per instruction set.
#include <cstdint>

#include "base/isa.h"

namespace morula {

/// Points in rows of a PointTable, and the vertex that asks which of them are near: closer than the pair's reach, and
/// not of its cell. The reach of a pair is (halfReach_i + halfReach_j) + skin. Lengths are the scene's.
struct NearQuery {
  struct Row {
    std::int32_t first, last;
  };
  const double *x, *y, *z, *slot, *halfReach;  // readable for eight beyond the last row
  const std::int32_t* vertex;                  // [point] its vertex number
  const Row* row;
  int rows;
  double px, py, pz, ownSlot, ownHalfReach, skin;  // the asking vertex
};

struct SearchKernels {
  /// Writes the vertex numbers of near points, row by row; returns how many. `out` has room for all of the rows' points
  /// and eight more.
  std::int32_t (*findNear)(const NearQuery&, std::int32_t* out);

  /// Puts up to `longestShortList` different numbers into rising order, without a branch on any of them.
  void (*sortShortList)(std::int32_t* numbers, std::int32_t count);
  static constexpr int longestShortList = 64;
};

const SearchKernels& searchKernels(Isa isa);

}  // namespace morula

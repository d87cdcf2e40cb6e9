#pragma once
// An unbounded grid, whose bins share a hash table: optimised spatial hashing [Teschner et al. 2003, §3]. First
// all vertices are put into the table, then each looks into the 27 bins around it. Its memory does not depend
// on how far apart cells are, as a grid's does.
#include "contacts/point_table.h"

namespace morula {

struct SpatialHash {
  Point low;
  double inverseBin = 0;            // [1/length]
  std::uint32_t mask = 0;           // the table's size − 1, a power of two
  std::vector<std::int32_t> start;  // [size + 1] into points
  PointTable points;
  std::vector<std::int32_t> binOf;  // scratch
};

void prepare(SpatialHash& hash, const SearchInput& input);
void searchBlock(const SpatialHash& hash, const SearchInput& input, int block, BlockLists& lists);

}  // namespace morula

#include "contacts/grid.h"

#include <algorithm>

namespace morula {

void prepare(GridSearch& grid, const SearchInput& input) {
  const Box box = boundingBox(input);
  const Vector extent = box.high - box.low;
  // A bin has a min size: otherwise doubling it would take long, and never end if reaches underflow.
  const double longest = std::max({extent.x, extent.y, extent.z});
  double binSize = std::max({safeBinSize(input.largestReach()), longest * 0x1p-30, 0x1p-1000});
  // At most four bins per vertex: doubling the bins' size divides their number by up to eight.
  const double most = 4.0 * input.bodies.livingVertices + 64;
  const auto bins = [&](double size) { return (extent.x / size + 1) * (extent.y / size + 1) * (extent.z / size + 1); };
  while (bins(binSize) > most) binSize *= 2;
  grid.low = box.low;
  grid.inverseBin = 1 / binSize;
  grid.nx = static_cast<int>(extent.x / binSize) + 1;
  grid.ny = static_cast<int>(extent.y / binSize) + 1;
  grid.nz = static_cast<int>(extent.z / binSize) + 1;
  sortIntoBins(
      grid.points, grid.start, grid.binOf, std::size_t(grid.nx) * grid.ny * grid.nz, input, [&](const Point& x) {
        return (grid.column(x.z, grid.low.z, grid.nz) * grid.ny + grid.column(x.y, grid.low.y, grid.ny)) * grid.nx +
               grid.column(x.x, grid.low.x, grid.nx);
      });
}

void searchBlock(const GridSearch& grid, const SearchInput& input, int block, BlockLists& lists) {
  const Bodies& bodies = input.bodies;
  // Goes cell by cell: the surroundings of one cell stay in the nearest cache.
  for (int lane = 0; lane < bodies.liveLanes(block); ++lane)
    for (int v = 0; v < bodies.verticesPerLane(block); ++v) {
      const int slot = block * blockLanes + lane;
      const Point x = input.vertex(slot, v);
      const int cx = grid.column(x.x, grid.low.x, grid.nx), cy = grid.column(x.y, grid.low.y, grid.ny),
                cz = grid.column(x.z, grid.low.z, grid.nz);
      const int left = std::max(cx - 1, 0), right = std::min(cx + 1, grid.nx - 1);
      NearQuery::Row rows[9];
      int count = 0;
      for (int z = std::max(cz - 1, 0); z <= std::min(cz + 1, grid.nz - 1); ++z)
        for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, grid.ny - 1); ++y) {
          const int bin = (z * grid.ny + y) * grid.nx;
          rows[count++] = {grid.start[bin + left], grid.start[bin + right + 1]};
        }
      lists.counters.binVisits += count * (right - left + 1);
      findNeighbours(lists, input, grid.points, rows, count, slot, v * blockLanes + lane, x);
    }
}

}  // namespace morula

#include "contacts/grid.h"

#include <algorithm>

namespace morula {

void fillGrid(Grid& grid, const Bodies& bodies, double binSize) {
  const int vertices = bodies.vertexCount(), total = bodies.count * vertices;
  Point low = bodies.vertex(0, 0), high = low;
  for (int slot = 0; slot < bodies.count; ++slot)
    for (int v = 0; v < vertices; ++v) {
      const Point x = bodies.vertex(slot, v);
      low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
    }
  const Vector extent = high - low;
  // At most four bins per vertex: doubling the bins' size divides their number by up to eight.
  const auto bins = [&](double size) {
    return (extent.x / size + 1) * (extent.y / size + 1) * (extent.z / size + 1);
  };
  while (bins(binSize) > 4.0 * total + 64) binSize *= 2;
  grid.low = low;
  grid.inverseBin = 1 / binSize;
  grid.nx = static_cast<int>(extent.x / binSize) + 1;
  grid.ny = static_cast<int>(extent.y / binSize) + 1;
  grid.nz = static_cast<int>(extent.z / binSize) + 1;

  grid.start.assign(std::size_t(grid.nx) * grid.ny * grid.nz + 1, 0);
  grid.binOf.resize(total);
  for (auto* a : {&grid.x, &grid.y, &grid.z, &grid.slot}) a->resize(total + blockLanes);
  grid.vertex.resize(total);
  // In order of vertex numbers: block, vertex, lane.
  const auto forEachVertex = [&](auto&& body) {
    int i = 0;
    for (int block = 0; block < bodies.blockCount(); ++block)
      for (int v = 0; v < vertices; ++v)
        for (int lane = 0; lane < bodies.liveLanes(block); ++lane, ++i) body(i, block, v, lane);
  };
  forEachVertex([&](int i, int block, int v, int lane) {
    const Point x = bodies.vertex(block * blockLanes + lane, v);
    const int bin =
        (grid.column(x.z, low.z, grid.nz) * grid.ny + grid.column(x.y, low.y, grid.ny)) * grid.nx +
        grid.column(x.x, low.x, grid.nx);
    grid.binOf[i] = bin;
    ++grid.start[bin + 1];
  });
  for (std::size_t bin = 1; bin < grid.start.size(); ++bin) grid.start[bin] += grid.start[bin - 1];
  forEachVertex([&](int i, int block, int v, int lane) {
    const int slot = block * blockLanes + lane;
    const Point x = bodies.vertex(slot, v);
    const std::int32_t at = grid.start[grid.binOf[i]]++;
    grid.x[at] = x.x;
    grid.y[at] = x.y;
    grid.z[at] = x.z;
    grid.vertex[at] = (block * vertices + v) * blockLanes + lane;
    grid.slot[at] = slot;
  });
  // Each start has moved to its bin's end: move them back.
  for (std::size_t bin = grid.start.size() - 1; bin > 0; --bin) grid.start[bin] = grid.start[bin - 1];
  grid.start[0] = 0;
}

}  // namespace morula

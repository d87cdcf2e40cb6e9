#include "contacts/point_table.h"

#include <algorithm>
#include <cmath>

namespace morula {

void PointTable::resize(int points) {
  for (auto* a : {&x, &y, &z, &slot, &halfReach}) a->resize(points + blockLanes);
  vertex.resize(points + blockLanes);
}

void findNeighbours(BlockLists& lists, const SearchInput& input, const PointTable& table, const NearQuery::Row* rows,
                    int rowCount, int slot, int row, const Point& x) {
  std::int64_t candidates = 0;
  for (int r = 0; r < rowCount; ++r) candidates += rows[r].last - rows[r].first;
  lists.counters.distanceTests += candidates;
  const NearQuery query{table.x.data(),
                        table.y.data(),
                        table.z.data(),
                        table.slot.data(),
                        table.halfReach.data(),
                        table.vertex.data(),
                        rows,
                        rowCount,
                        x.x,
                        x.y,
                        x.z,
                        double(slot),
                        input.halfReach[slot],
                        input.skin};
  VertexNumber* out = lists.room(candidates + 8);
  const std::int32_t found = input.kernels.findNear(query, out);
  if (found <= SearchKernels::longestShortList) input.kernels.sortShortList(out, found);
  else std::sort(out, out + found);
  lists.add(row, found);
}

Box boundingBox(const SearchInput& input) {
  Box box{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
  const auto include = [](double& low, double& high, double a) {
    if (!(std::abs(a) < 1e150)) return;  // points farther out belong to the bins at the border
    low = std::min(low, a);
    high = std::max(high, a);
  };
  forEachVertex(input.bodies, [&](int, int block, int v, int lane) {
    const Point x = input.vertex(block * blockLanes + lane, v);
    include(box.low.x, box.high.x, x.x);
    include(box.low.y, box.high.y, x.y);
    include(box.low.z, box.high.z, x.z);
  });
  if (!(box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z)) return {};
  return box;
}

}  // namespace morula

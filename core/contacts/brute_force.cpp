#include "contacts/brute_force.h"

namespace morula {
namespace {

std::int32_t neighboursOf(const SearchInput& input, int slot, const Point& x, VertexNumber* out) {
  const Bodies& bodies = input.bodies;
  std::int32_t found = 0;
  VertexNumber number = 0;
  for (int block = 0; block < bodies.blockCount(); ++block)
    for (int v = 0; v < bodies.verticesPerLane(block); ++v)
      for (int lane = 0; lane < blockLanes; ++lane, ++number) {
        const int other = block * blockLanes + lane;
        if (other == slot || lane >= bodies.liveLanes(block)) continue;
        const Vector d = input.vertex(other, v) - x;
        const double reach = input.reach(slot, other);
        if (dot(d, d) < reach * reach) out[found++] = number;
      }
  return found;
}

}  // namespace

void searchBlock(const BruteForce&, const SearchInput& input, int block, BlockLists& lists) {
  const Bodies& bodies = input.bodies;
  const int own = bodies.verticesPerLane(block);
  const std::int64_t others = bodies.livingVertices - own;
  for (int lane = 0; lane < bodies.liveLanes(block); ++lane)
    for (int v = 0; v < own; ++v) {
      const int slot = block * blockLanes + lane;
      const std::int32_t found = neighboursOf(input, slot, input.vertex(slot, v), lists.room(others));
      lists.add(v * blockLanes + lane, found);
      lists.counters.distanceTests += others;
    }
}

}  // namespace morula

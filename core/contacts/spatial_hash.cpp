#include "contacts/spatial_hash.h"

#include <algorithm>
#include <bit>

namespace morula {
namespace {

struct Bin {
  std::int32_t x, y, z;
};

/// Returns a bin's number along one axis; NaN goes to 0.
std::int32_t column(double a, double lowest, double inverseBin) {
  const double i = (a - lowest) * inverseBin;
  return i >= 0x1p30 ? 1 << 30 : i > 0 ? static_cast<std::int32_t>(i) : 0;
}

Bin binOf(const SpatialHash& h, const Point& x) {
  return {column(x.x, h.low.x, h.inverseBin), column(x.y, h.low.y, h.inverseBin), column(x.z, h.low.z, h.inverseBin)};
}

/// The primes are those of [Teschner et al. 2003, §3.1].
std::int32_t bucket(const SpatialHash& h, std::int32_t x, std::int32_t y, std::int32_t z) {
  const std::uint32_t mixed = (static_cast<std::uint32_t>(x) * 73856093u) ^
                              (static_cast<std::uint32_t>(y) * 19349663u) ^ (static_cast<std::uint32_t>(z) * 83492791u);
  return static_cast<std::int32_t>(mixed & h.mask);
}

/// The buckets of the 27 bins around a bin, each once: two bins may share a bucket. Returns how many.
int bucketsAround(const SpatialHash& h, const Bin& b, std::int32_t* buckets) {
  int count = 0;
  std::uint64_t seen = 0;  // a set bit: a bucket with these last six bits may be there already
  for (std::int32_t z = b.z - 1; z <= b.z + 1; ++z)
    for (std::int32_t y = b.y - 1; y <= b.y + 1; ++y)
      for (std::int32_t x = b.x - 1; x <= b.x + 1; ++x) {
        const std::int32_t next = bucket(h, x, y, z);
        const std::uint64_t bit = std::uint64_t(1) << (next & 63);
        const bool known = (seen & bit) && std::find(buckets, buckets + count, next) != buckets + count;
        seen |= bit;
        if (!known) buckets[count++] = next;
      }
  return count;
}

}  // namespace

void prepare(SpatialHash& h, const SearchInput& input) {
  const Box box = boundingBox(input);
  const Vector extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  h.low = box.low;
  h.inverseBin = 1 / std::max({safeBinSize(input.largestReach()), longest * 0x1p-30, 0x1p-1000});
  // At least two buckets per vertex, so that most buckets hold one bin's vertices.
  const std::uint32_t vertices = static_cast<std::uint32_t>(input.bodies.livingVertices);
  h.mask = std::bit_ceil(2 * vertices) - 1;
  sortIntoBins(h.points, h.start, h.binOf, std::size_t(h.mask) + 1, input, [&](const Point& x) {
    const Bin b = binOf(h, x);
    return bucket(h, b.x, b.y, b.z);
  });
}

void searchBlock(const SpatialHash& h, const SearchInput& input, int block, BlockLists& lists) {
  const Bodies& bodies = input.bodies;
  for (int lane = 0; lane < bodies.liveLanes(block); ++lane)
    for (int v = 0; v < bodies.verticesPerLane(block); ++v) {
      const int slot = block * blockLanes + lane;
      const Point x = input.vertex(slot, v);
      std::int32_t buckets[27];
      const int around = bucketsAround(h, binOf(h, x), buckets);
      NearQuery::Row rows[27];
      int count = 0;
      for (int i = 0; i < around; ++i) {
        rows[count] = {h.start[buckets[i]], h.start[buckets[i] + 1]};
        count += rows[count].first < rows[count].last;
      }
      lists.counters.binVisits += 27;
      findNeighbours(lists, input, h.points, rows, count, slot, v * blockLanes + lane, x);
    }
}

}  // namespace morula

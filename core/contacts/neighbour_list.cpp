#include "contacts/neighbour_list.h"

#include <algorithm>

#include "base/parallel.h"

namespace morula {

namespace {

// A pair acts within R_ij = √(2/(1/R_i² + 1/R_j²)) ≤ (R_i + R_j)/2, with 1/R² rounded to float in the
// snapshot: a little more than the mean of the radii is surely enough.
constexpr double rounding = 1 + 1e-6;

struct Search {
  const ContactKernels& kernels;
  const Bodies& bodies;
  const AlignedVector<double>& radius;
  double largestRadius, skin;
};

/// Appends the neighbours of one vertex, in rising order.
void searchVertex(NeighbourList::BlockLists& lists, const Search& s, const Grid& grid, int slot,
                  const Point& x) {
  const std::size_t first = lists.neighbours.size();
  const double farthest = rounding * 0.5 * (s.radius[slot] + s.largestRadius) + s.skin;
  NearQuery query{grid.x.data(), grid.y.data(), grid.z.data(), grid.slot.data(),   {}, 0, x.x,
                  x.y,           x.z,           double(slot),  farthest * farthest};
  const int cx = grid.column(x.x, grid.low.x, grid.nx), cy = grid.column(x.y, grid.low.y, grid.ny),
            cz = grid.column(x.z, grid.low.z, grid.nz);
  std::int32_t candidates = 0;
  for (int z = std::max(cz - 1, 0); z <= std::min(cz + 1, grid.nz - 1); ++z)
    for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, grid.ny - 1); ++y) {
      const int row = (z * grid.ny + y) * grid.nx;  // bins along x stand side by side
      query.row[query.rows++] = {grid.start[row + std::max(cx - 1, 0)],
                                 grid.start[row + std::min(cx + 1, grid.nx - 1) + 1]};
      candidates += query.row[query.rows - 1].last - query.row[query.rows - 1].first;
    }
  if (lists.near.size() < std::size_t(candidates)) lists.near.resize(candidates);
  const std::int32_t found = s.kernels.findNear(query, lists.near.data());
  for (std::int32_t i = 0; i < found; ++i) {
    const std::int32_t k = lists.near[i];
    // Cells differ in reach: the pair's own decides.
    const double dx = grid.x[k] - x.x, dy = grid.y[k] - x.y, dz = grid.z[k] - x.z;
    const double reach =
        rounding * 0.5 * (s.radius[slot] + s.radius[static_cast<int>(grid.slot[k])]) + s.skin;
    if (dx * dx + dy * dy + dz * dz < reach * reach) lists.neighbours.push_back(grid.vertex[k]);
  }
  std::sort(lists.neighbours.begin() + first, lists.neighbours.end());
}

/// Long lists first, so that the eight of a slice are of almost one length; ties by number: a counting sort.
void orderByLength(NeighbourList::BlockLists& lists) {
  const auto count = static_cast<std::int32_t>(lists.start.size()) - 1;
  const auto length = [&](std::int32_t i) { return lists.start[i + 1] - lists.start[i]; };
  std::int32_t longest = 0, listed = 0;
  for (std::int32_t i = 0; i < count; ++i) longest = std::max(longest, length(i)), listed += length(i) > 0;
  std::vector<std::int32_t>& place = lists.near;  // by length: where the next one goes
  place.assign(longest + 2, 0);
  for (std::int32_t i = 0; i < count; ++i) ++place[length(i)];
  std::int32_t next = 0;
  for (std::int32_t l = longest; l > 0; --l) std::swap(next, place[l]), next += place[l];
  lists.order.resize(listed);
  for (std::int32_t i = 0; i < count; ++i)
    if (length(i) > 0) lists.order[place[length(i)]++] = i;
}

/// The lists of one block's vertices, one behind the other.
void searchBlock(NeighbourList::BlockLists& lists, const Search& s, const Grid& grid, int block) {
  lists.start.assign(1, 0);
  lists.neighbours.clear();
  const int live = s.bodies.liveLanes(block);
  for (int v = 0; v < s.bodies.vertexCount(); ++v)
    for (int lane = 0; lane < blockLanes; ++lane) {
      const int slot = block * blockLanes + lane;
      if (lane < live) searchVertex(lists, s, grid, slot, s.bodies.vertex(slot, v));
      lists.start.push_back(static_cast<std::int32_t>(lists.neighbours.size()));
    }
  orderByLength(lists);
}

}  // namespace

void buildNeighbourList(NeighbourList& list, const ContactKernels& kernels, const Bodies& bodies,
                        const AlignedVector<double>& radius, int threads) {
  const int blocks = bodies.blockCount(), rowsPerBlock = bodies.vertexCount() * blockLanes;
  const VertexNumber far = blocks * rowsPerBlock;
  list.reference.assign(bodies.position.begin(), bodies.position.end());
  const double largest = *std::max_element(radius.begin(), radius.begin() + bodies.count);
  fillGrid(list.grid, bodies, rounding * largest + list.skin);
  list.perBlock.resize(blocks);
  parallelFor(blocks, threads, [&](int block) {
    searchBlock(list.perBlock[block], {kernels, bodies, radius, largest, list.skin}, list.grid, block);
  });

  // Where each block's slices and indices begin.
  list.firstSlice.assign(1, 0);
  list.slices.clear();
  list.pairs = 0;
  std::int64_t lines = 0;
  for (int block = 0; block < blocks; ++block) {
    const auto& lists = list.perBlock[block];
    list.pairs += lists.neighbours.size();
    for (std::size_t first = 0; first < lists.order.size(); first += blockLanes) {
      NeighbourSlice slice;
      slice.start = lines;
      slice.length =
          lists.start[lists.order[first] + 1] - lists.start[lists.order[first]];  // the longest of the eight
      for (std::size_t l = 0; l < blockLanes; ++l)
        slice.vertex[l] =
            first + l < lists.order.size() ? block * rowsPerBlock + lists.order[first + l] : far;
      list.slices.push_back(slice);
      lines += slice.length;
    }
    list.firstSlice.push_back(static_cast<std::int64_t>(list.slices.size()));
  }
  list.indices.resize(lines * blockLanes);
  parallelFor(blocks, threads, [&](int block) {
    const auto& lists = list.perBlock[block];
    for (std::int64_t s = list.firstSlice[block]; s < list.firstSlice[block + 1]; ++s) {
      const NeighbourSlice& slice = list.slices[s];
      for (int l = 0; l < blockLanes; ++l) {
        std::int32_t* out = list.indices.data() + slice.start * blockLanes + l;
        const VertexNumber own = slice.vertex[l] - block * rowsPerBlock;
        const bool there = slice.vertex[l] != far;
        const int length = there ? lists.start[own + 1] - lists.start[own] : 0;
        for (int k = 0; k < slice.length; ++k)
          out[k * blockLanes] = k < length ? lists.neighbours[lists.start[own] + k] : far;
      }
    }
  });
}

std::vector<VertexNumber> neighboursOf(const NeighbourList& list, VertexNumber g) {
  std::vector<VertexNumber> found;
  for (const NeighbourSlice& slice : list.slices)
    for (int l = 0; l < blockLanes; ++l)
      if (slice.vertex[l] == g)
        for (int k = 0; k < slice.length; ++k) {
          const VertexNumber j = list.indices[(slice.start + k) * blockLanes + l];
          // Behind the last vertex stands the far row, which fills up shorter lists.
          if (j < static_cast<VertexNumber>(list.perBlock.size() * (list.perBlock[0].start.size() - 1)))
            found.push_back(j);
        }
  return found;
}

}  // namespace morula

#include "contacts/neighbour_list.h"

#include <algorithm>

#include "base/parallel.h"

namespace morula {

namespace {

/// The lists of one block's vertices, one behind the other.
void searchBlock(NeighbourList::BlockLists& lists, const Grid& grid, const Bodies& bodies,
                 const AlignedVector<double>& radius, double skin, int block) {
  lists.start.assign(1, 0);
  lists.neighbours.clear();
  for (int v = 0; v < bodies.vertexCount(); ++v)
    for (int lane = 0; lane < blockLanes; ++lane) {
      const int slot = block * blockLanes + lane;
      if (lane < bodies.liveLanes(block)) {
        const Point x = bodies.vertex(slot, v);
        const std::size_t first = lists.neighbours.size();
        const int cx = grid.column(x.x, grid.low.x, grid.nx), cy = grid.column(x.y, grid.low.y, grid.ny),
                  cz = grid.column(x.z, grid.low.z, grid.nz);
        for (int z = std::max(cz - 1, 0); z <= std::min(cz + 1, grid.nz - 1); ++z)
          for (int y = std::max(cy - 1, 0); y <= std::min(cy + 1, grid.ny - 1); ++y) {
            const int row = (z * grid.ny + y) * grid.nx;  // bins along x stand side by side
            const auto* entry = grid.entries.data() + grid.start[row + std::max(cx - 1, 0)];
            const auto* end = grid.entries.data() + grid.start[row + std::min(cx + 1, grid.nx - 1) + 1];
            for (; entry != end; ++entry) {
              if (entry->slot == slot) continue;
              const double dx = entry->x - x.x, dy = entry->y - x.y, dz = entry->z - x.z;
              const double reach = 0.5 * (radius[slot] + radius[entry->slot]) + skin;
              if (dx * dx + dy * dy + dz * dz < reach * reach) lists.neighbours.push_back(entry->vertex);
            }
          }
        std::sort(lists.neighbours.begin() + first, lists.neighbours.end());
      }
      lists.start.push_back(static_cast<std::int32_t>(lists.neighbours.size()));
    }
  // Long lists first, so that the eight of a slice are of almost one length; ties by number.
  const auto length = [&](std::int32_t i) { return lists.start[i + 1] - lists.start[i]; };
  lists.order.clear();
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(lists.start.size()); ++i)
    if (length(i) > 0) lists.order.push_back(i);
  std::sort(lists.order.begin(), lists.order.end(), [&](std::int32_t a, std::int32_t b) {
    return length(a) != length(b) ? length(a) > length(b) : a < b;
  });
}

}  // namespace

void buildNeighbourList(NeighbourList& list, const Bodies& bodies, const AlignedVector<double>& radius, int threads) {
  const int blocks = bodies.blockCount(), rowsPerBlock = bodies.vertexCount() * blockLanes;
  const VertexNumber far = blocks * rowsPerBlock;
  list.reference.assign(bodies.position.begin(), bodies.position.end());
  fillGrid(list.grid, bodies, *std::max_element(radius.begin(), radius.begin() + bodies.count) + list.skin);
  list.perBlock.resize(blocks);
  parallelFor(blocks, threads, [&](int block) {
    searchBlock(list.perBlock[block], list.grid, bodies, radius, list.skin, block);
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
      slice.length = lists.start[lists.order[first] + 1] - lists.start[lists.order[first]];  // the longest of the eight
      for (std::size_t l = 0; l < blockLanes; ++l)
        slice.vertex[l] = first + l < lists.order.size() ? block * rowsPerBlock + lists.order[first + l] : far;
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
        for (int k = 0; k < slice.length; ++k) out[k * blockLanes] = k < length ? lists.neighbours[lists.start[own] + k] : far;
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
          if (j < static_cast<VertexNumber>(list.perBlock.size() * list.perBlock[0].start.size())) found.push_back(j);
        }
  return found;
}

}  // namespace morula

#include "contacts/slices.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/parallel.h"

namespace morula {
namespace {

/// Orders long lists first, so that the eight of a slice have almost one length; ties by number: a counting sort.
void orderByLength(BlockLists& block, const RowLists& lists) {
  const auto rows = static_cast<std::int32_t>(lists.length.size());
  std::int32_t longest = 0, listed = 0;
  for (std::int32_t l : lists.length) longest = std::max(longest, l), listed += l > 0;
  block.ofLength.assign(longest + 1, 0);  // where the next list of this length goes
  for (std::int32_t l : lists.length) ++block.ofLength[l];
  std::int32_t next = 0;
  for (std::int32_t l = longest; l > 0; --l) std::swap(next, block.ofLength[l]), next += block.ofLength[l];
  block.order.resize(listed);
  for (std::int32_t i = 0; i < rows; ++i)
    if (lists.length[i] > 0) block.order[block.ofLength[lists.length[i]]++] = i;
}

/// Writes one lane of a slice. `row`: −1 for none.
void writeLane(BlockLists& block, const NeighbourSlice& slice, int lane, const RowLists& lists, std::int32_t row,
               VertexNumber far) {
  std::int32_t* out = block.indices.data() + slice.start * blockLanes + lane;
  std::int32_t k = 0;
  if (row >= 0) {
    const VertexNumber* in = lists.neighbours.data() + lists.begin[row];
    for (; k < lists.length[row]; ++k) out[k * blockLanes] = in[k];
  }
  for (; k < slice.length; ++k) out[k * blockLanes] = far;
}

/// Adds slices of the rows in `order` behind the others.
void addSlices(BlockLists& block, const RowLists& lists, VertexNumber firstOfBlock, VertexNumber far) {
  const std::size_t firstNew = block.slices.size();
  std::int64_t lines = firstNew == 0 ? 0 : block.slices.back().start + block.slices.back().length;
  for (std::size_t first = 0; first < block.order.size(); first += blockLanes) {
    NeighbourSlice slice;
    slice.start = lines;
    slice.length = lists.length[block.order[first]];  // the longest of the eight
    for (std::size_t l = 0; l < blockLanes; ++l)
      slice.vertex[l] = first + l < block.order.size() ? firstOfBlock + block.order[first + l] : far;
    block.slices.push_back(slice);
    lines += slice.length;
  }
  block.indices.resize((lines + linesPrefetched) * blockLanes);
  std::fill(block.indices.begin() + lines * blockLanes, block.indices.end(), far);
  for (std::size_t s = firstNew; s < block.slices.size(); ++s)
    for (int l = 0; l < blockLanes; ++l) {
      const VertexNumber vertex = block.slices[s].vertex[l];
      const std::int32_t row = vertex == far ? -1 : vertex - firstOfBlock;
      if (row >= 0) block.place[row] = static_cast<std::int32_t>(s) * blockLanes + l;
      writeLane(block, block.slices[s], l, lists, row, far);
    }
}

}  // namespace

void cutIntoSlices(BlockLists& block, const RowLists& lists, VertexNumber firstOfBlock, VertexNumber far) {
  orderByLength(block, lists);
  block.slices.clear();
  block.place.assign(lists.length.size(), -1);
  addSlices(block, lists, firstOfBlock, far);
}

void cutIntoSlices(NeighbourList& list, const Bodies& bodies, int threads) {
  parallelFor(bodies.blockCount(), threads, [&](int block) {
    cutIntoSlices(list.perBlock[block], list.perBlock[block], bodies.blocks[block].firstLine * blockLanes,
                  bodies.lineCount() * blockLanes);
  });
}

void replaceInSlices(BlockLists& block, const RowLists& lists, std::span<const std::int32_t> rows,
                     VertexNumber firstOfBlock, VertexNumber far) {
  block.order.clear();
  for (std::int32_t row : rows) {
    const std::int32_t length = lists.length[row], place = block.place[row];
    NeighbourSlice* slice = place < 0 ? nullptr : &block.slices[place / blockLanes];
    const bool fits = length <= (slice ? slice->length : 0);
    if (!fits) block.order.push_back(row);
    if (!slice) continue;
    if (!fits) slice->vertex[place % blockLanes] = far;
    writeLane(block, *slice, place % blockLanes, lists, fits ? row : -1, far);
  }
  if (block.order.empty()) return;
  std::ranges::sort(block.order, {}, [&](std::int32_t row) { return std::tuple(-lists.length[row], row); });
  addSlices(block, lists, firstOfBlock, far);
}

}  // namespace morula

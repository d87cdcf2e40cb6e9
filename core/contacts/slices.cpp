#include "contacts/slices.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"

namespace morula {
namespace {

/// Long lists first, so that the eight of a slice are of almost one length; ties by number: a counting sort.
void orderByLength(RowLists& lists) {
  const auto rows = static_cast<std::int32_t>(lists.length.size());
  std::int32_t longest = 0, listed = 0;
  for (std::int32_t l : lists.length) longest = std::max(longest, l), listed += l > 0;
  lists.place.assign(longest + 1, 0);  // by length: where the next one goes
  for (std::int32_t l : lists.length) ++lists.place[l];
  std::int32_t next = 0;
  for (std::int32_t l = longest; l > 0; --l) std::swap(next, lists.place[l]), next += lists.place[l];
  lists.order.resize(listed);
  for (std::int32_t i = 0; i < rows; ++i)
    if (lists.length[i] > 0) lists.order[lists.place[lists.length[i]]++] = i;
}

void writeSlice(const NeighbourSlice& slice, const RowLists& lists, VertexNumber firstOfBlock, VertexNumber far,
                std::int32_t* indices) {
  for (int l = 0; l < blockLanes; ++l) {
    std::int32_t* out = indices + slice.start * blockLanes + l;
    std::int32_t k = 0;
    if (slice.vertex[l] != far) {
      const VertexNumber row = slice.vertex[l] - firstOfBlock;
      const VertexNumber* in = lists.neighbours.data() + lists.begin[row];
      for (; k < lists.length[row]; ++k) out[k * blockLanes] = in[k];
    }
    for (; k < slice.length; ++k) out[k * blockLanes] = far;
  }
}

}  // namespace

RowLists& foundLists(BlockLists& lists) { return lists; }
RowLists& actingLists(BlockLists& lists) { return lists.acting; }

void cutIntoSlices(NeighbourList& list, RowLists& (*listsOf)(BlockLists&), const Bodies& bodies, int threads) {
  const int blocks = bodies.blockCount();
  const VertexNumber far = bodies.lineCount() * blockLanes;
  const auto firstOf = [&](int block) { return bodies.blocks[block].firstLine * blockLanes; };
  parallelFor(blocks, threads, [&](int block) { orderByLength(listsOf(list.perBlock[block])); });

  // Where each block's slices and indices begin.
  list.firstSlice.assign(1, 0);
  list.slices.clear();
  std::int64_t lines = 0;
  for (int block = 0; block < blocks; ++block) {
    const RowLists& lists = listsOf(list.perBlock[block]);
    for (std::size_t first = 0; first < lists.order.size(); first += blockLanes) {
      NeighbourSlice slice;
      slice.start = lines;
      slice.length = lists.length[lists.order[first]];  // the longest of the eight
      for (std::size_t l = 0; l < blockLanes; ++l)
        slice.vertex[l] = first + l < lists.order.size() ? firstOf(block) + lists.order[first + l] : far;
      list.slices.push_back(slice);
      lines += slice.length;
    }
    list.firstSlice.push_back(static_cast<std::int64_t>(list.slices.size()));
  }
  list.indices.resize((lines + linesPrefetched) * blockLanes);
  std::fill(list.indices.begin() + lines * blockLanes, list.indices.end(), far);
  parallelFor(blocks, threads, [&](int block) {
    for (std::int64_t s = list.firstSlice[block]; s < list.firstSlice[block + 1]; ++s)
      writeSlice(list.slices[s], listsOf(list.perBlock[block]), firstOf(block), far, list.indices.data());
  });
}

}  // namespace morula

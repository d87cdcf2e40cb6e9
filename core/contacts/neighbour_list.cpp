#include "contacts/neighbour_list.h"

#include <algorithm>
#include <atomic>
#include <limits>

#include "base/parallel.h"
#include "contacts/any_search.h"
#include "contacts/slices.h"

namespace morula {
namespace {

// A pair acts within R_ij = √(2/(1/R_i² + 1/R_j²)) ≤ (R_i + R_j)/2, with 1/R² rounded to float in the
// snapshot: a little more than the mean of the radii is surely enough.
constexpr double rounding = 1 + 1e-6;

// Searches that can use threads take them.
template <class Search>
void prepareSearch(Search& search, const SearchInput& input, int threads) {
  if constexpr (requires { prepare(search, input, threads); }) prepare(search, input, threads);
  else prepare(search, input);
}

/// Max number of list entries that all blocks may keep together.
std::int64_t maxNumbers(const NeighbourList& list) {
  // Four bytes in BlockLists, up to nine while they are moved to a larger place, and four in slices: 16. Acting ones
  // stand in BlockLists once more.
  return static_cast<std::int64_t>(std::clamp(list.maxBytes / list.bytesPerNeighbour, 0.0, 1e15));
}

/// Fills all blocks' lists. Each thread may use its share of the memory that is left.
template <class Search>
void searchBlocks(Search& search, const SearchInput& input, NeighbourList& list, int threads) {
  const Bodies& bodies = input.bodies;
  std::atomic<std::int64_t> left = maxNumbers(list);
  parallelFor(bodies.blockCount(), threads, [&](int block) {
    BlockLists& lists = list.perBlock[block];
    lists.clear(bodies.verticesPerLane(block) * blockLanes);
    lists.most = std::min(left / threads, std::int64_t(std::numeric_limits<std::int32_t>::max()));
    try {
      searchBlock(search, input, block, lists);
    } catch (const ListsTooLong&) { throw ListsTooLong{block}; }
    left -= lists.used;
  });
}

/// Throws ListsTooLong where one thread, block after block, would have.
void requireRoomForLists(const NeighbourList& list) {
  std::int64_t left = maxNumbers(list);
  for (std::size_t block = 0; block < list.perBlock.size(); ++block) {
    if (list.perBlock[block].asked > left) throw ListsTooLong{static_cast<int>(block)};
    left -= list.perBlock[block].used;
  }
}

/// Searches all blocks. Whether lists are too long, and where, must not depend on the number of threads that share the
/// memory. If the shares do not suffice, one thread searches again and decides.
template <class Search>
void searchAllBlocks(Search& search, const SearchInput& input, NeighbourList& list, int threads) {
  try {
    searchBlocks(search, input, list, threads);
    return requireRoomForLists(list);
  } catch (const ListsTooLong&) {
    if (threads <= 1) throw;
  }
  searchBlocks(search, input, list, 1);
}

}  // namespace

NeighbourList makeNeighbourList(ContactSearch search, Isa isa) {
  NeighbourList list;
  list.kernels = &searchKernels(isa);
  switch (search) {
    case ContactSearch::grid: list.search = AnySearch{GridSearch{}}; break;
    case ContactSearch::aabbTree: list.search = AnySearch{TreeSearch{}}; break;
    case ContactSearch::spatialHash: list.search = AnySearch{SpatialHash{}}; break;
    case ContactSearch::bruteForce: list.search = AnySearch{BruteForce{}}; break;
  }
  return list;
}

void findNeighbourLists(NeighbourList& list, const Bodies& bodies, const AlignedVector<double>& radius, int threads) {
  const int blocks = bodies.blockCount();
  list.halfReach.resize(radius.size());
  for (std::size_t slot = 0; slot < radius.size(); ++slot)
    list.halfReach[slot] = rounding * 0.5 * radius[slot] * list.reach;
  const SearchInput input{*list.kernels,
                          bodies,
                          list.reference,
                          list.halfReach,
                          *std::max_element(list.halfReach.begin(), list.halfReach.end()),
                          list.skin};
  list.perBlock.resize(blocks);
  std::visit(
      [&](auto& search) {
        prepareSearch(search, input, threads);
        searchAllBlocks(search, input, list, threads);
        if constexpr (requires { search.preparation; }) list.counters += search.preparation;
      },
      list.search->way);
  list.pairs = 0;
  ++list.counters.searches;
  for (const BlockLists& lists : list.perBlock) {
    list.pairs += lists.counters.pairs;
    list.counters += lists.counters;
  }
}

void buildNeighbourList(NeighbourList& list, const Bodies& bodies, const AlignedVector<double>& radius, int threads) {
  findNeighbourLists(list, bodies, radius, threads);
  cutIntoSlices(list, bodies, threads);
}

std::vector<VertexNumber> neighboursOf(const NeighbourList& list, VertexNumber g) {
  std::size_t row = g;
  auto block = list.perBlock.begin();
  while (row >= block->begin.size()) row -= block++->begin.size();
  const auto first = block->neighbours.begin() + block->begin[row];
  return {first, first + block->length[row]};
}

}  // namespace morula

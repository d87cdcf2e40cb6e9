#pragma once
// The interface of all neighbour searches. Each is a struct with the memory that it keeps,
// and two functions: `prepare` once per search, then `searchBlock` for each block of cells, on any thread.
//
// All searches give one answer: the neighbours of vertex i are the vertices j of other cells with |x_j − x_i|² <
// reach², in these roundings and in rising order of their numbers.
#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/aligned.h"
#include "contacts/contacts_kernels.h"
#include "contacts/search_kernels.h"
#include "contacts/snapshot.h"
#include "physics/bodies.h"

namespace morula {

struct SearchInput {
  const SearchKernels& kernels;
  const Bodies& bodies;
  // Positions of vertices as other cells see them, laid out as Bodies::position. A vertex that is not finite has no
  // neighbours; such a step is the last.
  const Reals& points;
  const AlignedVector<double>& halfReach;  // [slot] [length]; 0 without a cell
  double largestHalfReach, skin;           // [length]

  Point vertex(int slot, int v) const { return bodies.read(points, slot, v); }
  double reach(int a, int b) const { return (halfReach[a] + halfReach[b]) + skin; }
  double largestReach() const { return (largestHalfReach + largestHalfReach) + skin; }
};

/// The work of searches: the same on every machine, thread count and instruction set.
struct SearchCounters {
  std::uint64_t searches = 0;
  std::uint64_t pairs = 0;          // neighbours found, each pair from both sides
  std::uint64_t distanceTests = 0;  // vertex against vertex
  std::uint64_t binVisits = 0;      // grid and hash: bins looked up
  std::uint64_t rootTests = 0;      // trees: cell against cell
  std::uint64_t boxTests = 0;       // trees: box against box, roots included
  std::uint64_t boxesRefitted = 0;  // trees
  std::uint64_t treesBuilt = 0;

  friend bool operator==(const SearchCounters&, const SearchCounters&) = default;
  SearchCounters& operator+=(const SearchCounters& other) {
    searches += other.searches, pairs += other.pairs, distanceTests += other.distanceTests;
    binVisits += other.binVisits, rootTests += other.rootTests, boxTests += other.boxTests;
    boxesRefitted += other.boxesRefitted, treesBuilt += other.treesBuilt;
    return *this;
  }
};

/// Thrown if there are more neighbours than there is memory for: cells overlap.
struct ListsTooLong {
  int block = 0;  // the block whose list is too long
};

/// The neighbours of one block's vertices; vertex v of lane l is row v·blockLanes + l.
struct RowLists {
  std::vector<std::int32_t> begin, length;  // [row] into neighbours
  std::vector<VertexNumber> neighbours;     // allocated longer than used
};

/// Memory is kept between searches, so that a steady run allocates nothing.
struct BlockLists : RowLists {
  std::int32_t used = 0;
  std::int64_t asked = 0;                                        // max room that was asked for
  std::int64_t most = std::numeric_limits<std::int32_t>::max();  // max numbers that may be kept
  SearchCounters counters;                                       // of this search

  RowLists acting;  // lists of `chosen` without pairs that cannot act for a while (acting_pairs.h)
  std::vector<std::int32_t> chosen;
  std::int64_t chosenAgain = 0;  // rows chosen again since all were chosen

  // Slices for the kernels (slices.h), of all pairs or of the acting ones; vertices without neighbours have none.
  std::vector<NeighbourSlice> slices;
  AlignedVector<std::int32_t> indices;
  std::vector<std::int32_t> place;            // [row] its slice · blockLanes + lane, or −1
  std::vector<std::int32_t> order, ofLength;  // scratch of the ordering

  void clear(int rows) {
    begin.assign(rows, 0);
    length.assign(rows, 0);
    used = 0, asked = 0;
    counters = {};
  }
  /// Returns the place of the next list, with room for `numbers` numbers. Throws ListsTooLong.
  VertexNumber* room(std::int64_t numbers) {
    asked = std::max(asked, used + numbers);
    if (asked > most) throw ListsTooLong{};
    const std::size_t needed = std::size_t(used) + numbers;
    if (neighbours.size() < needed) neighbours.resize(needed + needed / 4);
    return neighbours.data() + used;
  }
  void add(int row, std::int32_t count) {
    begin[row] = used;
    length[row] = count;
    used += count;
    counters.pairs += count;
  }
};

}  // namespace morula

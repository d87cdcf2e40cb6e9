#pragma once
// Which vertices of other cells may come within reach before the list is built anew: a Verlet list with a
// skin, found with a counting-sort grid. Cost linear in the number of vertices.
//
// A list holds every pair closer than the pair's influence radius plus the skin, so as long as no vertex has
// moved more than half the skin it misses no contact; pairs out of reach add exactly nothing. Forces
// therefore never depend on when it was built.
#include <cstdint>
#include <vector>

#include "base/aligned.h"
#include "contacts/contacts_kernels.h"
#include "contacts/grid.h"
#include "physics/bodies.h"

namespace morula {

struct NeighbourList {
  double skin = 0;                       // [length]
  AlignedVector<double> reference;       // positions it was built at, as Bodies::position
  std::vector<NeighbourSlice> slices;    // by block; vertices without neighbours have none
  std::vector<std::int64_t> firstSlice;  // [block + 1]
  AlignedVector<std::int32_t> indices;   // NeighbourSlice
  std::uint64_t pairs = 0;               // entries in all lists: each pair twice

  // Scratch, kept between builds so that a steady run allocates nothing.
  struct BlockLists {
    std::vector<std::int32_t> near;  // candidates of one vertex; scratch of the ordering
    std::vector<std::int32_t> start, order,
        neighbours;  // [vertex · blockLanes + lane + 1], sorted by length, concatenated
  };
  std::vector<BlockLists> perBlock;
  Grid grid;
};

/// Builds the list from the positions now. `radius` [slot]: influence radii. Positions must be finite.
void buildNeighbourList(NeighbourList& list, const ContactKernels& kernels, const Bodies& bodies,
                        const AlignedVector<double>& radius, int threads);

/// Vertex numbers of the neighbours of vertex g, in rising order. For tests and measures, not for the hot
/// path.
std::vector<VertexNumber> neighboursOf(const NeighbourList& list, VertexNumber g);

}  // namespace morula

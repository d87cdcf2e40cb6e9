#pragma once
// The neighbour list: vertices of other cells that may come within reach before the list is built anew. It is a Verlet
// list with a skin.
//
// A list holds every pair closer than the pair's influence radius plus the skin. As long as no vertex has moved more
// than half the skin, the list misses no contact; pairs out of reach add exactly nothing. So forces never depend on
// when the list was built, nor on how the pairs were found (search.h).
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/aligned.h"
#include "base/indirect.h"
#include "contacts/contact_search.h"
#include "contacts/contacts_kernels.h"
#include "contacts/search.h"

namespace morula {

struct AnySearch;

struct NeighbourList {
  // Constant
  const SearchKernels* kernels = nullptr;

  double maxBytes = INFINITY;     // [byte] that the lists may take
  double reach = 1;               // [1] reach of influence, in influence radii
  double bytesPerNeighbour = 16;  // [byte] that an entry may take, see maxNumbers
  double skin = 0;                // [length] with 0, the list is good only for the positions at its build
  Reals reference;                // points that the list is built from, laid out as Bodies::position
  std::uint64_t pairs = 0;        // entries in all lists: each pair twice
  SearchCounters counters;        // of all builds

  // Memory that is kept between builds, so that a steady run allocates nothing.
  Indirect<AnySearch> search;       // any_search.h
  AlignedVector<double> halfReach;  // [slot]
  std::vector<BlockLists> perBlock;
};

/// Makes an empty list that will be built by this search.
NeighbourList makeNeighbourList(ContactSearch search, Isa isa);

/// Builds the list from the points in `reference`, without its slices. `radius` [slot]: influence radii. Throws
/// ListsTooLong.
void findNeighbourLists(NeighbourList& list, const Bodies& bodies, const AlignedVector<double>& radius, int threads);

/// Builds the list as findNeighbourLists does, and cuts all pairs into slices.
void buildNeighbourList(NeighbourList& list, const Bodies& bodies, const AlignedVector<double>& radius, int threads);

/// Returns the numbers of vertex g's neighbours, in rising order. For tests and measures, not for the hot path.
std::vector<VertexNumber> neighboursOf(const NeighbourList& list, VertexNumber g);

}  // namespace morula

#pragma once
// Vertices in an order that suits a search, column by column, so that lanes can read neighbours side by side.
#include "contacts/search.h"
#include "mesh/mesh_measures.h"

namespace morula {

struct PointTable {
  AlignedVector<double> x, y, z, slot, halfReach;  // filled up so that whole lanes can be read
  std::vector<VertexNumber> vertex;

  void resize(int points);
  void set(std::int32_t at, const Point& p, VertexNumber number, int ofSlot, double itsHalfReach) {
    x[at] = p.x, y[at] = p.y, z[at] = p.z;
    vertex[at] = number, slot[at] = ofSlot, halfReach[at] = itsHalfReach;
  }
};

/// Adds to the lists of vertex `row` of lane `slot % blockLanes` all points of the rows that are near `x`.
void findNeighbours(BlockLists& lists, const SearchInput& input, const PointTable& table, const NearQuery::Row* rows,
                    int rowCount, int slot, int row, const Point& x);

/// Returns the corners of the smallest box around all vertices, without numbers that are not finite, or enormous. An
/// empty box is {0, 0, 0} twice.
Box boundingBox(const SearchInput& input);

/// Calls body(i, block, vertex, lane) for each vertex of a living cell, in order of vertex numbers.
template <class Body>
void forEachVertex(const Bodies& bodies, Body&& body) {
  int i = 0;
  for (int block = 0; block < bodies.blockCount(); ++block) {
    const int live = bodies.liveLanes(block), vertices = bodies.verticesPerLane(block);
    for (int v = 0; v < vertices; ++v)
      for (int lane = 0; lane < live; ++lane, ++i) body(i, block, v, lane);
  }
}

/// Puts all vertices into the table, bin after bin, those of a bin in order of their numbers: a counting
/// sort. `start` [bins + 1]; `binOf` is scratch. `chooseBin` must give numbers in [0, bins).
template <class ChooseBin>
void sortIntoBins(PointTable& table, std::vector<std::int32_t>& start, std::vector<std::int32_t>& binOf,
                  std::size_t bins, const SearchInput& input, ChooseBin&& chooseBin) {
  const Bodies& bodies = input.bodies;
  const int total = bodies.livingVertices;
  table.resize(total);
  binOf.resize(total);
  start.assign(bins + 1, 0);
  forEachVertex(bodies, [&](int i, int block, int v, int lane) {
    binOf[i] = chooseBin(input.vertex(block * blockLanes + lane, v));
    ++start[binOf[i] + 1];
  });
  for (std::size_t bin = 1; bin <= bins; ++bin) start[bin] += start[bin - 1];
  forEachVertex(bodies, [&](int i, int block, int v, int lane) {
    const int slot = block * blockLanes + lane;
    table.set(start[binOf[i]]++, input.vertex(slot, v), (bodies.blocks[block].firstLine + v) * blockLanes + lane, slot,
              input.halfReach[slot]);
  });
  // Each start has moved to its bin's end: move them back.
  for (std::size_t bin = bins; bin > 0; --bin) start[bin] = start[bin - 1];
  start[0] = 0;
}

/// Returns the width of bins that keeps points within reach in neighbouring bins in spite of rounding: up to 2^30 bins
/// along an axis, a coordinate's bin is off by less than 1e-6.
inline double safeBinSize(double reach) { return reach * (1 + 1e-6); }

}  // namespace morula

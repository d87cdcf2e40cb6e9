#pragma once
// A uniform grid over the bounding box of all vertices, filled by a counting sort: bin after bin, the
// vertices of a bin in rising order of number.
#include <cstdint>
#include <vector>

#include "base/aligned.h"
#include "contacts/snapshot.h"
#include "physics/bodies.h"

namespace morula {

struct Grid {
  Point low;          // corner of bin 0
  double inverseBin;  // [1/length]
  int nx, ny, nz;

  std::vector<std::int32_t> start;  // [bin + 1]
  // The vertices, bin after bin: [start[bin] … start[bin + 1]); filled up so that whole lanes can be read.
  AlignedVector<double> x, y, z, slot;
  std::vector<VertexNumber> vertex;
  std::vector<std::int32_t> binOf;  // scratch, [slot · vertexCount + vertex]

  int column(double a, double lowest, int n) const {
    const int i = static_cast<int>((a - lowest) * inverseBin);
    return i < 0 ? 0 : i >= n ? n - 1 : i;
  }
};

/// Bins are at least `binSize` wide, wider where the box is so large that more than a few bins per vertex
/// would stand empty. Positions must be finite.
void fillGrid(Grid& grid, const Bodies& bodies, double binSize);

}  // namespace morula

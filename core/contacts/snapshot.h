#pragma once
// What the contact laws read of a vertex: one cache line, copied of all vertices at one moment, so that forces
// are computed from data that no thread changes, in any order and on any number of threads.
#include <cstddef>
#include <cstdint>

#include "base/precision.h"

namespace morula {

struct SnapshotRow {
  double x, y, z;     // [length]
  double vx, vy, vz;  // [length/time] at the same moment
  float nx, ny, nz;  // outward unit normal, area-weighted; to float precision, the same seen from either side
  float inverseRadiusSquared;  // of the influence radius [1/length²]
};
static_assert(sizeof(SnapshotRow) == 64);

/// The same in a scene of single precision.
struct SingleSnapshotRow {
  float x, y, z;
  float vx, vy, vz;
  float nx, ny, nz;
  float inverseRadiusSquared;
  float padding[6];
};
static_assert(sizeof(SingleSnapshotRow) == 64);

/// What the energy law reads of a vertex (surface_kernel.h): the place where its surface stands instead of the
/// vertex's own, and the normal in full, for the couples of forces on either side to match.
struct SurfaceRow {
  double x, y, z;              // [length]
  double nx, ny, nz;           // [1] outward, about 1 long
  float vx, vy, vz;            // [length/time] damping and friction alone read it
  float inverseRadiusSquared;  // [1/length²]
};
static_assert(sizeof(SurfaceRow) == 64 &&
              offsetof(SurfaceRow, inverseRadiusSquared) == offsetof(SnapshotRow, inverseRadiusSquared));

/// Memory for one or the other.
struct alignas(64) RowMemory {
  unsigned char bytes[64];
  friend bool operator==(const RowMemory&, const RowMemory&) = default;
};

RowMemory asMemory(const SnapshotRow& row, Precision precision);
SnapshotRow readRow(const RowMemory& memory, Precision precision);
SurfaceRow readSurfaceRow(const RowMemory& memory, Precision precision);

// Vertex number g = (the block's first line + vertex) · blockLanes + lane: a vertex of all cells of a block
// side by side. Behind the last one stands a row far away that fills up lists: nothing is within its reach.
using VertexNumber = std::int32_t;

}  // namespace morula

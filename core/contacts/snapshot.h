#pragma once
// The snapshot of a vertex that contact laws read: one cache line, copied for all vertices at one moment. Forces are
// computed from data that no thread changes, in any order and on any number of threads.
#include <cstdint>

#include "base/precision.h"

namespace morula {

struct SnapshotRow {
  double x, y, z;              // [length] place of the surface (surface_kernel.h); the thesis' law: of the vertex
  double nx, ny, nz;           // [1] outward normal, about 1 long; not rounded, so that couples match on both sides
  float vx, vy, vz;            // [length/time] at the same moment
  float inverseRadiusSquared;  // of the influence radius [1/length²]
};
static_assert(sizeof(SnapshotRow) == 64);

/// A row of a snapshot in a scene of single precision.
struct SingleSnapshotRow {
  float x, y, z;
  float nx, ny, nz;
  float vx, vy, vz;
  float inverseRadiusSquared;
  float padding[6];
};
static_assert(sizeof(SingleSnapshotRow) == 64);

/// Memory for a row of either precision.
struct alignas(64) RowMemory {
  unsigned char bytes[64];
  friend bool operator==(const RowMemory&, const RowMemory&) = default;
};

RowMemory asMemory(const SnapshotRow& row, Precision precision);
SnapshotRow readRow(const RowMemory& memory, Precision precision);

// Vertex number g = (the block's first line + vertex) · blockLanes + lane: a vertex of all cells of a block
// side by side. Behind the last one stands a row far away that fills up lists: nothing is within its reach.
using VertexNumber = std::int32_t;

}  // namespace morula

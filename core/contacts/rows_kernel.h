#pragma once
// Snapshot rows as lanes: 64 bytes in one cache line, read and written by index. Turning rows into columns of lanes is
// a transposition in registers, not a gather. A row of doubles has its velocity and 1/R² as floats, two in place of a
// double.
#include "base/lane_prefetch.h"
#if defined(MORULA_SINGLE)
#include "base/lane_rows_single.h"
#else
#include "base/lane_rows_double.h"
#endif
#include "contacts/contacts_kernels.h"
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct Rows {
  Vec x, n, v;
  Lanes inverseRadiusSquared;
};

MORULA_INLINE const Real* numbersOf(const RowMemory* rows) { return reinterpret_cast<const Real*>(rows); }

MORULA_INLINE Rows loadRows(const RowMemory* rows, const VertexNumber* index) {
  Lanes c[rowColumns];
  loadRows(numbersOf(rows), index, c);
#if defined(MORULA_SINGLE)
  return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9]};
#else
  Rows r{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {}, {}};
  unpackFloats(c[6], r.v.x, r.v.y);
  unpackFloats(c[7], r.v.z, r.inverseRadiusSquared);
  return r;
#endif
}

/// Loads one row into every lane.
MORULA_INLINE Rows loadRowInAllLanes(const RowMemory* row) {
  const Real* r = numbersOf(row);
#if defined(MORULA_SINGLE)
  const Real* f = r + 6;
#else
  const float* f = reinterpret_cast<const float*>(r + 6);
#endif
  const auto all = [](double a) { return Lanes(a); };
  return {{all(r[0]), all(r[1]), all(r[2])},
          {all(r[3]), all(r[4]), all(r[5])},
          {all(f[0]), all(f[1]), all(f[2])},
          all(f[3])};
}

/// Returns a bound on the length of `a`, at most 16 % above it, without a root. The bound is convex, linear where the
/// order of sizes is the same, and right for (1, 0, 0) and (1, 1, 0); for (1, 1, 1) it is 1.83.
MORULA_INLINE Lanes atMost(const Vec& a) {
  const Lanes x = abs(a.x), y = abs(a.y), z = abs(a.z);
  return 0.41421357 * (x + y + z) + 0.58578644 * max(x, max(y, z));
}

/// Rounds a velocity as rows hold it.
MORULA_INLINE Vec asStored(const Vec& v) {
#if defined(MORULA_SINGLE)
  return v;
#else
  Vec stored;
  Lanes none;
  unpackFloats(packFloats(v.x, v.y), stored.x, stored.y);
  unpackFloats(packFloats(v.z, 0.0), stored.z, none);
  return stored;
#endif
}

/// Stores `width` consecutive rows.
MORULA_INLINE void storeRows(RowMemory* rows, const Rows& r) {
#if defined(MORULA_SINGLE)
  const Lanes columns[rowColumns] = {
      r.x.x, r.x.y, r.x.z, r.n.x, r.n.y, r.n.z, r.v.x, r.v.y, r.v.z, r.inverseRadiusSquared, 0.0, 0.0};
#else
  const Lanes columns[rowColumns] = {
      r.x.x, r.x.y, r.x.z, r.n.x, r.n.y, r.n.z, packFloats(r.v.x, r.v.y), packFloats(r.v.z, r.inverseRadiusSquared)};
#endif
  storeRows(reinterpret_cast<Real*>(rows), columns);
}

/// Prefetches the rows that will be read some lines later: neighbours are anywhere in memory, which no processor
/// predicts. With 1024 cells this halves the cost of contact, and with few it costs nothing.
MORULA_INLINE void prefetchRows(const RowMemory* rows, const VertexNumber* index) {
  for (int i = 0; i < width; ++i) __builtin_prefetch(rows + index[linesPrefetched * blockLanes + i]);
}

/// Prefetches, with each slice of a block, its share of the next block's rows and forces: sorted by length, slices name
/// a block's own vertices in an unpredictable order too. With 2048 cells this takes a quarter off the step. Positions
/// and velocities, for which the ring pass and the kick behind it wait, take off another 8 %. The next block's slices
/// are about as many and as long as this block's.
MORULA_INLINE void prefetchNextBlock(const BlockSlices& block, std::int64_t slice, const RowMemory* rows,
                                     const Real* force) {
  constexpr int ofRows = blockLanes * sizeof(RowMemory), ofForces = vertexStride * sizeof(Real);
  const std::int64_t own = block.firstVertex / blockLanes;
  const std::int64_t first = block.nextLine + slice * block.linesPerSlice, last = first + block.linesPerSlice;
  for (std::int64_t line = first; line < last; ++line) {
    prefetch<ofRows>(rows, line * ofRows);
    prefetch<ofForces>(force, line * ofForces);
    prefetch<ofForces>(block.position.place, (line - own) * ofForces);
    prefetch<ofForces>(block.velocity.place, (line - own) * ofForces);
  }
  constexpr int ofIndices = blockLanes * sizeof(std::int32_t);
  prefetch<sizeof(NeighbourSlice)>(block.nextSlices, slice * std::int64_t(sizeof(NeighbourSlice)));
  const NeighbourSlice& now = block.slices[slice];
  for (std::int64_t line = now.start & ~1; line < now.start + now.length; line += 2)
    prefetch<2 * ofIndices>(block.nextIndices, line * ofIndices);
}

/// Returns the largest lane, at least 0; a NaN counts as 0.
MORULA_INLINE double largestOf(Lanes a) {
  Real spread[width];
  store(spread, a);
  double result = 0;
  for (Real s : spread) result = s > result ? s : result;
  return result;
}

/// [ContactKernels::takeSnapshot]
inline double takeSnapshot(const TemplateView& mesh, const BlockView& b, const double* inverseRadiusSquared,
                           RealPointer reference, RowMemory* rows, ChangeCount&) {
  Lanes farthest = 0.0;
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane), w = loadVec(b.predicted, v, lane), g = loadVec(b.gradient, v, lane);
      const Vec n = (1.0 / sqrt(dot(g, g) + tiny)) * g;
      storeRows(rows + std::int64_t(v) * blockLanes + lane, {x, n, w, load(inverseRadiusSquared + lane)});
      const Vec moved = x - loadVec(reference, v, lane);
      farthest = max(dot(moved, moved), farthest);
    }
  return largestOf(farthest);
}

}  // namespace morula::MORULA_ISA

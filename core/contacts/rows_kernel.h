#pragma once
// Snapshot rows as lanes. A row of doubles has its normal and 1/R² as floats, two in the place of one double.
#include "base/lane_prefetch.h"
#include "base/lane_rows.h"
#include "contacts/contacts_kernels.h"
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct Rows {
  Vec x, v, n;
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
  unpackFloats(c[6], r.n.x, r.n.y);
  unpackFloats(c[7], r.n.z, r.inverseRadiusSquared);
  return r;
#endif
}

/// `width` consecutive ones.
MORULA_INLINE void storeRows(RowMemory* rows, const Rows& r) {
#if defined(MORULA_SINGLE)
  const Lanes columns[rowColumns] = {
      r.x.x, r.x.y, r.x.z, r.v.x, r.v.y, r.v.z, r.n.x, r.n.y, r.n.z, r.inverseRadiusSquared, 0.0, 0.0};
#else
  const Lanes columns[rowColumns] = {r.x.x,
                                     r.x.y,
                                     r.x.z,
                                     r.v.x,
                                     r.v.y,
                                     r.v.z,
                                     packFloats(r.n.x, r.n.y),
                                     packFloats(r.n.z, r.inverseRadiusSquared)};
#endif
  storeRows(reinterpret_cast<Real*>(rows), columns);
}

/// Prefetches the rows that will be read some lines later: neighbours are anywhere in memory, which no processor
/// predicts. With 1024 cells this halves the cost of contact, and with few it costs nothing.
MORULA_INLINE void prefetchRows(const RowMemory* rows, const VertexNumber* index) {
  for (int i = 0; i < width; ++i) __builtin_prefetch(rows + index[linesPrefetched * blockLanes + i]);
}

/// With each slice of a block, a line of the next block's rows and forces: sorted by length, slices name a block's
/// own vertices in an unpredictable order too. With 2048 cells this takes a quarter off the step.
MORULA_INLINE void prefetchNextBlock(const BlockSlices& block, std::int64_t slice, const RowMemory* rows,
                                     const Real* force) {
  constexpr int ofRows = blockLanes * sizeof(RowMemory), ofForces = vertexStride * sizeof(Real);
  const std::int64_t line = block.nextLine + slice;
  prefetch<ofRows>(rows, line * ofRows);
  prefetch<ofForces>(force, line * ofForces);
}

/// force[g] += sum, lane by lane; the far row (number `vertices`) has no place.
MORULA_INLINE void addToForces(Real* force, const VertexNumber* vertex, std::int32_t vertices,
                               const Vec& sum) {
  Real x[width], y[width], z[width];
  store(x, sum.x);
  store(y, sum.y);
  store(z, sum.z);
  for (int i = 0; i < width; ++i) {
    if (vertex[i] >= vertices) continue;
    const auto v = static_cast<std::uint32_t>(vertex[i]);  // dividing it by eight is a shift
    Real* f = force + std::size_t(v / blockLanes) * vertexStride + v % blockLanes;
    f[0] += x[i];
    f[blockLanes] += y[i];
    f[2 * blockLanes] += z[i];
  }
}

/// Adds to each vertex of the slices, lane by lane, the sum of a law's forces from its neighbours. `Law`:
/// load(rows, index) → its data of `width` vertices; force(i, j, c) → the force on i; where it `adheres`
/// force(i, j, c, strength), with each pair's own.
template <class Law>
MORULA_INLINE void addSlices(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                             const ContactConstants& c, Real* force) {
  for (std::int64_t s = 0; s < block.count; ++s) {
    const NeighbourSlice& slice = block.slices[s];
    prefetchNextBlock(block, s, rows, force);
    for (int lane = 0; lane < blockLanes; lane += width) {
      const auto i = Law::load(rows, slice.vertex + lane);
      Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      const std::int32_t* index = indices + slice.start * blockLanes + lane;
      for (int k = 0; k < slice.length; ++k, index += blockLanes) {
        prefetchRows(rows, index);
        if constexpr (Law::adheres)
          sum += Law::force(i, Law::load(rows, index), c, load(c.adhesion + (index - indices)));
        else sum += Law::force(i, Law::load(rows, index), c);
      }
      addToForces(force, slice.vertex + lane, c.vertices, sum);
    }
  }
}

/// The largest lane, at least 0; a NaN counts as 0.
MORULA_INLINE double largestOf(Lanes a) {
  Real spread[width];
  store(spread, a);
  double result = 0;
  for (Real s : spread) result = s > result ? s : result;
  return result;
}

/// [ContactKernels::takeSnapshot]
inline double takeSnapshot(const TemplateView& mesh, const BlockView& b, const double* inverseRadiusSquared,
                           RealPointer reference, RowMemory* rows) {
  Lanes farthest = 0.0;
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane), w = loadVec(b.predicted, v, lane),
                g = loadVec(b.gradient, v, lane);
      const Vec n = (1.0 / sqrt(dot(g, g) + tiny)) * g;
      storeRows(rows + std::int64_t(v) * blockLanes + lane, {x, w, n, load(inverseRadiusSquared + lane)});
      const Vec moved = x - loadVec(reference, v, lane);
      farthest = max(dot(moved, moved), farthest);
    }
  return largestOf(farthest);
}

}  // namespace morula::MORULA_ISA

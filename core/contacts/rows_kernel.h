#pragma once
// Snapshot rows as lanes.
#include "contacts/snapshot.h"
#include "physics/lane_vec3.h"

namespace morula::MORULA_ISA {

struct Rows {
  Vec x, v, n;
  Lanes inverseRadiusSquared;
};

MORULA_INLINE Rows loadRows(const double* rows, const VertexNumber* index) {
  Lanes c[8];
  loadRows(rows, index, c);
  Rows r{{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {}, {}};
  unpackFloats(c[6], r.n.x, r.n.y);
  unpackFloats(c[7], r.n.z, r.inverseRadiusSquared);
  return r;
}

/// Has the rows brought that will be read some lines on: the next slices' neighbours stand anywhere, and no
/// processor guesses where. With 1024 cells this halves the cost of contact, and with few it costs nothing.
MORULA_INLINE void fetchAhead(const double* rows, const VertexNumber* index) {
  for (int i = 0; i < width; ++i)
    __builtin_prefetch(rows + std::int64_t(index[linesFetchedAhead * blockLanes + i]) * 8);
}

/// force[g] += sum, lane by lane; the far row (number `vertices`) has no place.
MORULA_INLINE void addToForces(double* force, const VertexNumber* vertex, std::int32_t vertices,
                               const Vec& sum) {
  double x[width], y[width], z[width];
  store(x, sum.x);
  store(y, sum.y);
  store(z, sum.z);
  for (int i = 0; i < width; ++i) {
    if (vertex[i] >= vertices) continue;
    double* f = force + std::int64_t(vertex[i] / blockLanes) * vertexStride + vertex[i] % blockLanes;
    f[0] += x[i];
    f[blockLanes] += y[i];
    f[2 * blockLanes] += z[i];
  }
}

/// [ContactKernels::takeSnapshot]
inline double takeSnapshot(const TemplateView& mesh, const BlockView& b, const double* inverseRadiusSquared,
                           const double* reference, double* rows) {
  Lanes farthest = 0.0;
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane), w = loadVec(b.predicted, v, lane),
                g = loadVec(b.gradient, v, lane);
      const Vec n = (1.0 / squareRoot(dot(g, g) + 1e-280)) * g;
      const Lanes columns[8] = {x.x,
                                x.y,
                                x.z,
                                w.x,
                                w.y,
                                w.z,
                                packFloats(n.x, n.y),
                                packFloats(n.z, load(inverseRadiusSquared + lane))};
      storeRows(rows + (std::int64_t(v) * blockLanes + lane) * 8, columns);
      const Vec moved = x - loadVec(reference, v, lane);
      farthest = larger(dot(moved, moved), farthest);
    }
  double spread[width];
  store(spread, farthest);
  double result = 0;
  for (double s : spread) result = s > result ? s : result;
  return result;
}

}  // namespace morula::MORULA_ISA

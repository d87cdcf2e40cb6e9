#pragma once
// The thesis' contact: implicit planes and a penalty force that would part the vertex in one time step
// [Nilsson 2008, §4.3]. Kept as an option, so that the pair law's difference can be shown.
//
// Detection (§4.3.1): each vertex is a plane with a normal, and has influence up to r < R. From j's plane, i is deep by
// max(0, −(x_i − x_j)·n_j) along n_j; from i's plane, j is deep by max(0, −(x_j − x_i)·n_i), which moves i along −n_i.
// The pair's vector is the mean of the two, and i's penetration vector d the mean over all j, weighted by 1/r.
//
// Response (§4.3.2, eq. 4.8), per unit of mass, d̂ against the push: f = −½ d̂ (|d|/Δt² + v·d̂/Δt + f_other·d̂).
// Its stiffness is ∝ 1/Δt², it sees the absolute velocity, and nothing acts back on the other cell.
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// [ContactKernels::addThesisForces]
inline void addThesisForces(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                            const ContactConstants& c, RealPointer forces) {
  Real* force = forces;
  for (std::int64_t s = 0; s < block.count; ++s) {
    const NeighbourSlice& slice = block.slices[s];
    prefetchNextBlock(block, s, rows, force);
    for (int lane = 0; lane < blockLanes; lane += width) {
      const Rows i = loadRows(rows, slice.vertex + lane);
      Vec depth{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      Lanes weights = 0.0;
      const std::int32_t* index = indices + slice.start * blockLanes + lane;
      for (int k = 0; k < slice.length; ++k, index += blockLanes) {
        prefetchRows(rows, index);
        const Rows j = loadRows(rows, index);
        const Vec apart = i.x - j.x;
        const Lanes distanceSquared = dot(apart, apart);
        const Lanes nearness = distanceSquared * (0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared));  // (r/R)²
        const Mask near = (nearness < Lanes(1.0)) & (dot(i.n, j.n) < Lanes(0.0));
        // R/r, kept finite where vertices coincide.
        const Lanes weight = select(near, 1.0 / sqrt(nearness + 1e-12), 0.0);
        const Lanes seenFromJ = max(-dot(apart, j.n), Lanes(0.0)), seenFromI = max(dot(apart, i.n), Lanes(0.0));
        depth += (0.5 * weight) * (seenFromJ * j.n - seenFromI * i.n);
        weights += weight;
      }
      Real x[width], y[width], z[width], vx[width], vy[width], vz[width], w[width];
      store(x, depth.x), store(y, depth.y), store(z, depth.z), store(w, weights);
      store(vx, i.v.x), store(vy, i.v.y), store(vz, i.v.z);
      for (int l = 0; l < width; ++l) {
        const VertexNumber g = slice.vertex[lane + l];
        const double square = x[l] * x[l] + y[l] * y[l] + z[l] * z[l];
        if (g >= c.vertices || !(square > 0)) continue;
        Real* f = force + std::int64_t(g / blockLanes) * vertexStride + g % blockLanes;
        const double m = block.vertexMass[g % blockLanes];
        const double length = __builtin_sqrt(square), ux = x[l] / length, uy = y[l] / length,
                     uz = z[l] / length;  // −d̂
        const double other = (f[0] * ux + f[blockLanes] * uy + f[2 * blockLanes] * uz) / m;
        const double speed = vx[l] * ux + vy[l] * uy + vz[l] * uz;
        const double push = 0.5 * m * ((length / w[l]) / (c.timeStep * c.timeStep) - speed / c.timeStep - other);
        f[0] += push * ux;
        f[blockLanes] += push * uy;
        f[2 * blockLanes] += push * uz;
      }
    }
  }
}

}  // namespace morula::MORULA_ISA

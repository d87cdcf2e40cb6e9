#pragma once
// Contact of spheres. For two spheres whose centres are closer than r = r_i + r_j, with n = (x_i − x_j)/|x_i − x_j|,
//
//   f = max(0, K (r − |x_i − x_j|) − C v·n) n,   v = v_i − v_j
//
// on i, and viscosity as in pair_law_kernel.h. Exchanging i and j negates f bit for bit. Two spheres with
// one centre feel no force: it would have no direction.
//
// Adhesion pulls with S [force] of the pair (adhesion.h) where they overlap, and beyond over a gap g with S (1 −
// g²/δ²)², δ = (r_i + r_j)/8: the force does not jump, and its slope ends where the force ends. S is the force between
// smooth spheres whose surfaces take the work W per area to part, 2πW r_i r_j/(r_i + r_j) [Derjaguin et al. 1975].
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

struct Spheres {
  Vec x, v;
  Lanes radius;
};

template <bool withViscosity, bool withAdhesion>
struct SphereLaw {
  // Rows of spheres hold the velocity where a mesh's have the normal, and the radius behind the velocity.
  static MORULA_INLINE Spheres load(const RowMemory* rows, const VertexNumber* index) {
    Lanes c[rowColumns];
    loadRows(numbersOf(rows), index, c);
    return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, c[6]};
  }
  static MORULA_INLINE Vec force(const Spheres& i, const Spheres& j, const ContactConstants& c, Lanes adhesion = 0.0);
};

/// [ContactKernels::takeSnapshot]
inline double takeSphereSnapshot(const TemplateView&, const BlockView& b, const double* inverseRadiusSquared,
                                 RealPointer reference, RowMemory* rows, ChangeCount&) {
  Lanes farthest = 0.0;
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Vec x = loadVec(b.position, 0, lane), w = loadVec(b.predicted, 0, lane);
    const Lanes inverse = load(inverseRadiusSquared + lane);
    // Influence reaches over the diameter (makeCentre); lanes without a cell have no influence.
    const Lanes radius = select(inverse > Lanes(0.0), 0.5 / sqrt(inverse), 0.0);
#if defined(MORULA_SINGLE)
    const Lanes columns[rowColumns] = {x.x, x.y, x.z, w.x, w.y, w.z, radius, 0.0, 0.0, inverse, 0.0, 0.0};
#else
    const Lanes columns[rowColumns] = {x.x, x.y, x.z, w.x, w.y, w.z, radius, packFloats(0.0, inverse)};
#endif
    storeRows(reinterpret_cast<Real*>(rows + lane), columns);
    const Vec moved = x - loadVec(reference, 0, lane);
    farthest = max(dot(moved, moved), farthest);
  }
  return largestOf(farthest);
}

template <bool withViscosity, bool withAdhesion>
MORULA_INLINE Vec SphereLaw<withViscosity, withAdhesion>::force(const Spheres& i, const Spheres& j,
                                                                const ContactConstants& c, Lanes adhesion) {
  const Vec apart = i.x - j.x, relative = i.v - j.v;
  const Lanes distance = sqrt(dot(apart, apart)), depth = (i.radius + j.radius) - distance;
  const Vec n = (1.0 / (distance + tiny)) * apart;
  const Lanes opening = dot(relative, n);
  const Lanes push = Lanes(c.stiffness) * depth - Lanes(c.damping) * opening;
  const Lanes size = select((depth > Lanes(0.0)) & (push > Lanes(0.0)), push, 0.0);
  Vec f = size * n;
  if constexpr (withAdhesion) {
    const Lanes overReach = min(max(-depth, Lanes(0.0)) * 8.0 / ((i.radius + j.radius) + tiny), Lanes(1.0));
    const Lanes fade = 1.0 - overReach * overReach;
    f -= (adhesion * (fade * fade)) * n;
  }
  if constexpr (withViscosity) {
    const Vec slip = relative - opening * n;
    const Lanes slipSpeed = max(sqrt(dot(slip, slip)), Lanes(c.slipSpeed));
    f -= min((Lanes(c.viscosity) * size) / slipSpeed, Lanes(c.strongestGrip)) * slip;
  }
  return f;
}

/// force[g] += sum, lane by lane; the far row (number `vertices`) has no place.
MORULA_INLINE void addToForces(Real* force, const VertexNumber* vertex, std::int32_t vertices, const Vec& sum) {
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

/// [ContactKernels::addSphereForces]
template <bool withViscosity, bool withAdhesion>
inline void addSphereForces(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                            const ContactConstants& c, RealPointer force) {
  using Law = SphereLaw<withViscosity, withAdhesion>;
  for (std::int64_t s = 0; s < block.count; ++s) {
    const NeighbourSlice& slice = block.slices[s];
    prefetchNextBlock(block, s, rows, force);
    for (int lane = 0; lane < blockLanes; lane += width) {
      const Spheres i = Law::load(rows, slice.vertex + lane);
      Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      const std::int32_t* index = indices + slice.start * blockLanes + lane;
      for (int k = 0; k < slice.length; ++k, index += blockLanes) {
        prefetchRows(rows, index);
        sum +=
            Law::force(i, Law::load(rows, index), c, withAdhesion ? load(c.adhesion + (index - indices)) : Lanes(0.0));
      }
      addToForces(force, slice.vertex + lane, c.vertices, sum);
    }
  }
}

}  // namespace morula::MORULA_ISA

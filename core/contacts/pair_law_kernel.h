#pragma once
// The pair-symmetric contact law. Between vertex i and vertex j of another cell, r = |x_i − x_j| < R:
//
//   n  = (n_j − n_i)/|n_j − n_i|      the direction that parts them: from j's cell to i's
//   g  = (x_i − x_j)·n                gap; negative where the cells overlap
//   w  = (1 − ρ²/R²)²                 fades with the distance ρ² = r² − g² along the surfaces, not with the
//   depth s  = |n_j − n_i|²/4               1 for surfaces face to face, 0 for parallel normals: no contact
//   from behind f  = w s max(0, −K g − C v_n) n   on i, with v_n = (v_i − v_j)·n; K and C are constants, not
//   made of Δt
//
// Exchanging i and j turns n and f round and leaves the rest: f_ij = −f_ji bit for bit, so momentum is kept
// to rounding. Coulomb friction adds −μ|f| t/max(|t|, v_slip) with t the relative velocity along the surface:
// antisymmetric as well.
#include "contacts/contacts_kernels.h"
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

template <bool withFriction>
MORULA_INLINE Vec pairForce(const Rows& i, const Rows& j, const ContactConstants& c) {
  const Vec apart = i.x - j.x, facing = j.n - i.n, relative = i.v - j.v;
  const Lanes distanceSquared = dot(apart, apart), facingSquared = dot(facing, facing);
  const Lanes radius = 0.5 * (i.radius + j.radius), radiusSquared = radius * radius;
  const Lanes facingLength = squareRoot(facingSquared);
  // One division for 1/|n_j − n_i| and 1/R². Where it is not finite nothing acts: select below.
  const Lanes both = 1.0 / (facingLength * radiusSquared);
  const Vec n = (both * radiusSquared) * facing;
  const Lanes height = dot(apart, n);
  const Lanes gap = larger(height, larger(dot(apart, j.n), -dot(apart, i.n)));
  const Lanes alongSquared = distanceSquared - height * height;
  const Lanes fade = 1.0 - alongSquared * (both * facingLength);
  const Lanes push = Lanes(-c.stiffness) * gap - Lanes(c.damping) * dot(relative, n);
  const Lanes size = (fade * fade) * (0.25 * facingSquared) * push;
  // facingSquared > 1e-12: below, n is only rounding.
  const Mask acts = (distanceSquared < radiusSquared) & (push > Lanes(0.0)) & (facingSquared > Lanes(1e-12));
  Vec f{select(acts, size * n.x, 0.0), select(acts, size * n.y, 0.0), select(acts, size * n.z, 0.0)};
  if constexpr (withFriction) {
    const Vec slip = relative - dot(relative, n) * n;
    const Lanes slipSpeed = larger(squareRoot(dot(slip, slip)), Lanes(c.slipSpeed));
    const Lanes drag = (Lanes(c.friction) * size) / slipSpeed;
    f -= {select(acts, drag * slip.x, 0.0), select(acts, drag * slip.y, 0.0),
          select(acts, drag * slip.z, 0.0)};
  }
  return f;
}

/// [ContactKernels::addPairForces]
template <bool withFriction>
inline void addPairForces(const NeighbourSlice* slices, std::int64_t count, const std::int32_t* indices,
                          const double* rows, const ContactConstants& c, const double*, int, double* force) {
  for (std::int64_t s = 0; s < count; ++s)
    for (int lane = 0; lane < blockLanes; lane += width) {
      const NeighbourSlice& slice = slices[s];
      const Rows i = loadRows(rows, slice.vertex + lane);
      Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      const std::int32_t* index = indices + slice.start * blockLanes + lane;
      for (int k = 0; k < slice.length; ++k, index += blockLanes)
        sum += pairForce<withFriction>(i, loadRows(rows, index), c);
      addToForces(force, slice.vertex + lane, c.vertices, sum);
    }
}

}  // namespace morula::MORULA_ISA

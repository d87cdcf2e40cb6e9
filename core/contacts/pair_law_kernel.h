#pragma once
// The pair-symmetric contact law. Between vertex i and vertex j of another cell, r = |x_i − x_j| < R:
//
//   h = (n_j − n_i)/2                  from j's cell to i's; 1 long for surfaces face to face and 0 for parallel
//                                      normals, so that a thin cell's far side does not act
//   g = max((x_i − x_j)·n_j,           gap: how far i stands before j's plane, or j before i's, whichever is
//           (x_j − x_i)·n_i)           farther; negative only where both planes say that the cells overlap
//   w = (1 − ρ²/R²)²                   fades with the distance along the surfaces, ρ² = r² − g², not with depth
//   f = w max(0, −K g − C v·h) h       on i, with v = v_i − v_j; K and C are constants, independent of Δt
//
// Exchanging i and j negates h and f; everything else is unchanged. So f_ij = −f_ji bit for bit, and momentum is
// kept to rounding. Coulomb friction adds −min(μ|f|/max(|t|, v_slip), c_max) t with t the relative velocity along
// the surface: antisymmetric as well. Below v_slip it is a damper; c_max keeps it from reversing the slip within a
// step (contacts.cpp), or else vertices that press on each other oscillate from step to step, and one unit in the
// last place grows twentyfold in a step. 1/R² is the mean of the two vertices' 1/R_i², which needs no division.
//
// Adhesion adds −S max(0, g) (1 − r²/R²)² h, with S of the pair (adhesion.h). At g = 0 it begins where repulsion
// ends, and at r = R it ends with its slope: no force jumps. Between flat surfaces it has a potential along the
// normal, and to part them takes the work W that S is made of; symmetric in i and j, so it keeps momentum, too.
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

template <bool withFriction, bool withAdhesion>
struct PairLaw {
  static constexpr bool adheres = withAdhesion;
  static MORULA_INLINE Rows load(const RowMemory* rows, const VertexNumber* index) {
    return loadRows(rows, index);
  }
  static MORULA_INLINE Vec force(const Rows& i, const Rows& j, const ContactConstants& c,
                                 Lanes adhesion = 0.0);
};

template <bool withFriction, bool withAdhesion>
MORULA_INLINE Vec PairLaw<withFriction, withAdhesion>::force(const Rows& i, const Rows& j,
                                                             const ContactConstants& c, Lanes adhesion) {
  const Vec apart = i.x - j.x, relative = i.v - j.v, h = 0.5 * (j.n - i.n);
  const Lanes gap = max(dot(apart, j.n), -dot(apart, i.n));
  const Lanes distanceSquared = dot(apart, apart), alongSquared = distanceSquared - gap * gap;
  const Lanes inverseRadiusSquared = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);
  const Lanes fade = 1.0 - alongSquared * inverseRadiusSquared;
  const Lanes opening = dot(relative, h);
  const Lanes push = Lanes(-c.stiffness) * gap - Lanes(c.damping) * opening;
  const Lanes nearness = distanceSquared * inverseRadiusSquared;  // (r/R)²
  const Mask acts = (nearness < Lanes(1.0)) & (push > Lanes(0.0));
  const Lanes size = select(acts, fade * fade * push, 0.0);
  Vec f = size * h;
  if constexpr (withAdhesion) {
    const Lanes nearFade = max(1.0 - nearness, Lanes(0.0));
    f -= (adhesion * max(gap, Lanes(0.0)) * (nearFade * nearFade)) * h;
  }
  if constexpr (withFriction) {
    const Lanes facing = dot(h, h) + tiny;
    const Vec slip = relative - (opening / facing) * h;
    const Lanes slipSpeed = max(sqrt(dot(slip, slip)), Lanes(c.slipSpeed));
    const Lanes grip = (Lanes(c.friction) * size) * sqrt(facing) / slipSpeed;
    f -= min(grip, Lanes(c.strongestGrip)) * slip;
  }
  return f;
}

/// [ContactKernels::addPairForces]
template <bool withFriction, bool withAdhesion>
inline void addPairForces(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                          const ContactConstants& c, RealPointer force) {
  addSlices<PairLaw<withFriction, withAdhesion>>(block, indices, rows, c, force);
}

}  // namespace morula::MORULA_ISA

#pragma once
// Contact and adhesion of cells: an energy for each pair of vertices i, j of two cells, and its exact gradient.
//
//   y     position of the surface at a vertex, n its outward normal (surface_kernel.h);  a = y_i − y_j
//   κ     1/R², the mean of both vertices' (R: influence radius, one mean edge at rest)
//   u     max(0, 1 − κ² a⁴)                       fades with the distance, 0 from R on
//   w     max(0, 1 − κ a²/α²),  α = 3/2           the same for attraction: farther, and with a less steep fall
//   h     (n_j − n_i)/2                           from j's cell to i's; 1 long face to face
//   D     max(0, −a·h)                            overlap: by how much the planes half-way between i and j overlap
//   B     κ D² u                                  (depth over reach)² for vertices that lie on each other
//   m     1 − n_i·n_j                             2 face to face, 0 for parallel normals
//   s     t² (3 − 2t),  t = min(m/m₀, 1), m₀ = ½  1, but less for nearly parallel normals, as on a thin cell's far side
//   z     m² (3 − m)/4                            the same, with a less steep rise
//
//   E = ½ s K D² u² (1 + β₁ B + β₂ B²)  −  T/6 z w³,   β₁ = 6, β₂ = 200                                      [energy]
//
// The first part repels: K [force/length]. Face to face its energy rises until B = 0.38, at a depth of 0.74 R, where it
// is 4.5 K R². Surfaces that are pressed deeper would pass through each other, so the run ends before (deepestHeld). β₁
// and β₂ multiply B, not κ D². Otherwise vertices far beside each other, where u ends, would be so stiff that many
// cells together never come to rest. The second part attracts: over flat surfaces that touch it sums up to the work of
// separation W per area, whatever the mesh; T [energy] follows from W. Where vertices crowd it saturates: the force is
// that of T_eff in place of T, and no arrangement holds more than 1.1 W per area (adhesion.h). Attraction reaches farther than
// repulsion: with α = 1 each vertex attracts only the next few, and vertices hold each other one by one. Then the
// border of a contact stays where it is, and the contact's size depends on the way that cells came to it.
//
// y and n depend on the vertices' one-rings, so the gradient of the energy does, too. With
//
//   E_D = s K D u² (1 + 2β₁ B + 3β₂ B²)                                ∂E/∂D
//   E_q = −κ a² s K D² u (2 + 3β₁ B + 4β₂ B²) + T/(2α²) z w²           ∂E/∂(κa²)
//   E_m = ½ ds/dm K D² u² (1 + β₁ B + β₂ B²) − ¾ m (2 − m) T/6 w³      ∂E/∂m,   ds/dm = 6 t (1 − t)/m₀
//
// the pair adds to the sums of vertex i
//
//   f = E_D h − 2κ E_q a                    −∂E/∂y_i
//   q = −½ E_D a + E_m n_j                  −∂E/∂n_i
//
// and surface_kernel.h distributes f and q to the vertices. Exchanging i and j negates f and gives the q of j, so
// momentum is kept to rounding. So is angular momentum, since E does not change when both surfaces are turned together.
//
// Stiffness of a pair: at h fixed, the second derivative of the first part along a is, with q = κ a²,
//
//   (D/a)² s K (u² (1 + 6β₁ B + 15β₂ B²) + 16 q² (q² − u) (1 + 3β₁ B + 6β₂ B²) − 6 q² u (2 + 3β₁ B + 4β₂ B²))
//     ≤ K (1 + 6β₁ B + 15β₂ B²) + 16 K S,   S = s κ D² q³ (1 + 3β₁ B + 6β₂ B²)
//
// since q/κ = a², and D/a is 1 at most where normals are 1 long. The first term is that of vertices face to face
// (hardeningAt), where q and the second term are small. The second term is 16 K and more for vertices that lie in each
// other's cell and nearly R apart: where edges are stretched beyond R, vertices slide past each other's reach, and rest
// behind each other at the end of u.
//
// Damping adds s C u² ḋ to E_D where the sum repels, with the closing speed of the surfaces ḋ = −(v_i − v_j)·h. It acts
// along the gradient of D, with its couple, so it keeps both momenta. ḋ leaves out the rate at which normals turn,
// which cancels in the sum over a surface: damping takes energy from surfaces, although a single pair may add some. It
// may push a little before surfaces overlap, so that no force is discontinuous.
//
// Viscosity acts along a: −min(2μ N/max(v_t, v_slip), c_max) (v·â) â, with N = E_D, the normal force face to face and
// v_t the speed along the surface. A central force of the pair keeps both momenta and only takes energy. Over a
// surface, where neighbours lie on all sides of a vertex, half of it acts along the slip: hence the factor 2. Two
// vertices face to face have a along the normal and so no viscosity; the limit μN holds in the mean over positions of
// meshes, for fast slip. c_max (strongestGrip in contacts.cpp) keeps it from reversing the slip within a step. At the
// slip speeds of cells c_max alone acts, a damper that does not depend on μ and N: nothing sticks, and the resistance
// does not converge with the mesh. It is not Coulomb's friction.
//
// The gap by mean normals and forces that follow from a potential through the normals are those of convergent contact
// potentials [Li et al. 2020; Li et al. 2023]; here pairs are of vertices, so that each vertex only gathers forces.
#include "contacts/crowding_kernel.h"
#include "contacts/surface_kernel.h"

namespace morula::MORULA_ISA {

// PairLaw computes 2D in place of D and 4B in place of B, with powers of two in its constants: the same bits with fewer
// operations.
template <bool withViscosity, bool withAdhesion>
struct PairLaw {
  MORULA_INLINE explicit PairLaw(const ContactConstants& c)
      : stiffness(c.stiffness / 4),
        damping(c.damping / 4),
        viscosity(4 * c.viscosity),  // 2 μ E_D = 4 μ E_D/2
        slipSpeed(c.slipSpeed),
        strongestGrip(c.strongestGrip) {}

  /// Adds what j does to i. `adhesion`: T_eff [energy]. `deepest`: 4B.
  MORULA_INLINE void add(const Rows& i, const Rows& j, Lanes adhesion, SurfaceForce& sum, Lanes& deepest) const {
    const Vec toward = j.x - i.x, relative = j.v - i.v, apartNormals = j.n - i.n;  // −a, −(v_i − v_j), 2h
    const Lanes square = dot(toward, toward);
    const Lanes curvature = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);  // κ
    const Lanes ratio = curvature * square, nearness = min(ratio, 1.0);
    Lanes overlap = dot(toward, apartNormals);  // 2D; negative: the distance
    if constexpr (single)                       // the far row's squares are infinite
      overlap = select(nearness < Lanes(1.0), overlap, 0.0);
    const Lanes closing = dot(relative, apartNormals);                       // 2ḋ
    const Lanes pressing = stiffness * overlap, damped = damping * closing;  // K D/2, C ḋ/2
    if constexpr (!withAdhesion && width <= 2)  // the pair adds exactly nothing; of more lanes one nearly always acts
      if (!any(max(overlap, pressing + damped) > Lanes(0.0))) return;
    const Lanes u = (1.0 - nearness) * (1.0 + nearness);
    const Lanes m = 1.0 - dot(i.n, j.n);
    const Lanes depth = max(overlap, Lanes(0.0)), depthSquare = depth * depth;
    const Lanes b = curvature * depthSquare * u, barrier = stiffness * depthSquare;  // 4B, K D²
    deepest = max(b, deepest);
    const Lanes push = pressing * (1.0 + b * (2 * hardening1 / 4 + (3 * hardening2 / 16) * b)) + damped;
    Lanes su = u, byTurn = 0.0;
    const bool turned = any(m < Lanes(minFacing));  // s is 1 and ds/dm is 0 for normals 60° apart or more
    if (turned) {
      const Lanes t = min((1 / minFacing) * m, 1.0);
      su = ((t * t) * (3.0 - 2.0 * t)) * u;
      byTurn = ((3 / minFacing) * (t * (1.0 - t))) *
               ((barrier * (u * u)) * (1.0 + b * (hardening1 / 4 + (hardening2 / 16) * b)));
    }
    const Lanes half = (su * u) * max(push, Lanes(0.0));                                                   // E_D/2
    Lanes byFade = (nearness * (su * barrier)) * (4.0 + b * (3 * hardening1 / 2 + (hardening2 / 2) * b));  // −2E_q
    if constexpr (withAdhesion) {
      constexpr double perReach = 1 / (attractionReach * attractionReach);  // 1/α²
      const Lanes w = 1.0 - min(perReach * ratio, 1.0), held = adhesion * (w * w);
      byFade -= (((0.25 * perReach) * m) * (m * (3.0 - m))) * held;
      byTurn -= ((0.125 * m) * (2.0 - m)) * (held * w);
    }
    sum.force += half * apartNormals - (curvature * byFade) * toward;
    if (withAdhesion || turned) sum.turn += byTurn * j.n + half * toward;
    else sum.turn += half * toward;
    if constexpr (withViscosity) {
      const Lanes slipSquare = max(dot(relative, relative) - 0.25 * (closing * closing), Lanes(0.0));
      const Lanes slip = max(sqrt(slipSquare), slipSpeed);
      const Lanes grip = min(viscosity * half, strongestGrip * slip);
      sum.force += (grip * dot(relative, toward) / (slip * square + tiny)) * toward;
    }
  }

  Lanes stiffness, damping, viscosity, slipSpeed, strongestGrip;  // the first two over 4
};

/// [ContactKernels::findSteepest]
inline void findSteepest(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                         std::int32_t vertices, double* largest) {
  for (int lane = 0; lane < blockLanes; ++lane) largest[lane] = 0;
  for (std::int64_t s = 0; s < block.count; ++s)
    for (int lane = 0; lane < blockLanes; lane += width) {
      const VertexNumber* vertex = block.slices[s].vertex + lane;
      const std::int32_t* index = indices + block.slices[s].start * blockLanes + lane;
      const Rows i = loadRows(rows, vertex);
      Lanes steepest = 0.0;
      for (int k = 0; k < block.slices[s].length; ++k, index += blockLanes) {
        const Rows j = loadRows(rows, index);
        const Vec a = i.x - j.x;
        const Lanes curvature = 0.5 * (i.inverseRadiusSquared + j.inverseRadiusSquared);
        const Lanes nearness = min(curvature * dot(a, a), 1.0), square = nearness * nearness;
        const Lanes depth = max(select(nearness < Lanes(1.0), -0.5 * dot(a, j.n - i.n), 0.0), Lanes(0.0));
        const Lanes t = min((1 / minFacing) * (1.0 - dot(i.n, j.n)), 1.0), facing = (t * t) * (3.0 - 2.0 * t);
        const Lanes overReach = curvature * (depth * depth), b = overReach * (1.0 - square);
        steepest = max(square * (nearness * facing) * (overReach * (1.0 + b * (3 * hardening1 + (6 * hardening2) * b))),
                       steepest);
      }
      Real spread[width];
      store(spread, steepest);
      for (int l = 0; l < width; ++l) {
        if (vertex[l] >= vertices) continue;
        double& cell = largest[static_cast<std::uint32_t>(vertex[l]) % blockLanes];
        cell = spread[l] > cell ? spread[l] : cell;
      }
    }
}

/// [ContactKernels::addPairForces]
template <bool withViscosity, bool withAdhesion>
inline void addPairForces(const BlockSlices& block, const std::int32_t* indices, const RowMemory* rows,
                          const ContactConstants& c, RealPointer force) {
  const PairLaw<withViscosity, withAdhesion> law(c);
  const SurfaceDepths depths(block);
  clearSurface(block);
  Lanes deepest = 0.0;
  for (std::int64_t s = 0; s < block.count; ++s) {
    const NeighbourSlice& slice = block.slices[s];
    prefetchNextBlock(block, s, rows, force);
    for (int lane = 0; lane < blockLanes; lane += width) {
      const Rows i = loadRows(rows, slice.vertex + lane);
      SurfaceForce sum;
      [[maybe_unused]] Saturation own;
      if constexpr (withAdhesion) own = loadSaturation(c.saturation, slice.vertex + lane);
      const std::int32_t* index = indices + slice.start * blockLanes + lane;
      for (int k = 0; k < slice.length; ++k, index += blockLanes) {
        prefetchRows(rows, index);
        Lanes adhesion = 0.0;
        if constexpr (withAdhesion)
          adhesion = saturate(load(c.adhesion + (index - indices)), load(c.adhesionPerWork + (index - indices)), own,
                              loadSaturation(c.saturation, index));
        law.add(i, loadRows(rows, index), adhesion, sum, deepest);
      }
      storeOnSurface(block, depths, slice.vertex + lane, c.vertices, i, sum);
    }
  }
  moveToVertices(block, force);
  *block.deepest = 0.25 * largestOf(deepest);
}

}  // namespace morula::MORULA_ISA

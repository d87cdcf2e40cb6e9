#pragma once
// The surface that contacts act on, and the forces that its vertices get from it.
//
//   n = ν G/√(G² + ε² R⁴),  ε = 2      normal, with G = 6∇V of the one-ring (physics/ring_kernel.h). Of six equal
//                                      triangles G² = 27 R⁴ and n is 1 long, by ν² = 1 + ε²/27; where a ring folds n
//                                      fades to 0 smoothly, and turns no faster than a ring of size R does.
//   U = mean of the ring − x           the vertex' distance from its one-ring
//   y = x + λ U − γ δ n                where the surface stands,  λ = 1/8,  γ = 0.65
//
// Faces cut across a curved surface: the surface that holds the cell's volume lies δ inside the smooth surface through
// its vertices (physics/sag.h). δ is the cell's, not the vertex' own −¼ U·n. A vertex that is pressed flat has no U·n,
// and yet the smooth surface of the cell beside it stands out by δ, so that it would be pressed flat too far. γ δ
// leaves out the third that surfaces overlap by when they press on each other, and what λ U adds at the rim of a
// contact. These λ and γ let nine pressed pairs, whose meshes lie in nine ways, have the contact areas (−2.8 to 3.8 %),
// pressures (−0.2 to 0.5 %) and places (1.4e-3 radii) of the limit on icosphere 2. With λ = 1/8 alone areas are 5 to 12
// % too large.
//
// λ U evens the surface out where it is sharp. Without it rims, where three cells meet, slip into each other under
// contacts that are soft beside membranes, and cells take twice as long to come to rest (γ = 0.74 alone: as good for
// pressed pairs).
//
// A force f on y and q = −∂E/∂n give the vertices (n_v neighbours around v; k runs over its ring, counter-clockwise):
//
//   t   = (q' − n (n·q')/ν²) ν/√(G² + ε² R⁴),  q' = q − γ δ f    −∂E/∂G; 1/√… = √(1 − n²/ν²)/(ε R²)
//   F_v = (1 − λ) f_v + Σ_k λ f_k/n_k + Σ_k (x_{k−1} − x_{k+1}) × t_k
//
// for G_k does not depend on x_k, and changes by (x_{k+1}' − x_{k−1}') × of k's own ring, which are the neighbours that
// v and k share. The sums over all vertices of these forces and of their couples about any point are those of f and q.
#include "contacts/rows_kernel.h"

namespace morula::MORULA_ISA {

/// Sums over the pairs of a vertex.
struct SurfaceForce {
  Vec force{Lanes(0.0), Lanes(0.0), Lanes(0.0)};  // −∂E/∂y, with damping and viscosity
  Vec turn{Lanes(0.0), Lanes(0.0), Lanes(0.0)};   // −∂E/∂n
};

/// Adds the changes between two rows of `width` vertices, of which the first is number `row` of the block. Returns the
/// sums.
MORULA_INLINE Lanes countChange(const ChangeCount& count, int row, const Rows& before, const Rows& now) {
  const Lanes faster = atMost(now.v - before.v), fasterBefore = loadFloats(count.speeds + row);
  const Lanes change = loadFloats(count.change + row) + Lanes(count.perTurning) * atMost(now.n - before.n) +
                       Lanes(count.perStraying) * atMost(now.x - (before.x + Lanes(count.sinceLast) * before.v)) +
                       Lanes(count.perSpeed) * faster + Lanes(count.perDrift) * fasterBefore;
  storeFloats(count.speeds + row, fasterBefore + faster);
  storeFloats(count.change + row, change);
  return change;
}

/// Finds rows whose change has reached the margin, or is NaN.
inline void findEnded(ChangeCount& count, int rows, int liveLanes) {
  for (int row = 0; row < rows; row += blockLanes)
    for (int lane = 0; lane < liveLanes; lane += width) {
      const unsigned cells = (1u << (liveLanes - lane < width ? liveLanes - lane : width)) - 1;
      const unsigned ended = cells & ~bits(loadFloats(count.change + row + lane) < Lanes(count.margin));
      for (unsigned left = ended; left != 0; left &= left - 1)
        count.ended[count.endedCount++] = row + lane + __builtin_ctz(left);
    }
}

// takeSnapshot prefetches this many vertices ahead what the step has not read yet. With 1024 cells this takes a tenth
// off the step.
constexpr int linesAhead = 16;

/// [ContactKernels::takeSnapshot] of the surface.
template <bool counting>
inline double takeSurface(const TemplateView& mesh, const BlockView& b, const double* inverseRadiusSquared,
                          RealPointer reference, RowMemory* rows, ChangeCount& count) {
  Lanes farthest = 0.0, maxChanged = 0.0;
  constexpr VertexNumber consecutive[blockLanes] = {0, 1, 2, 3, 4, 5, 6, 7};
  constexpr std::int64_t ofRows = blockLanes * sizeof(RowMemory), ofReference = vertexStride * sizeof(Real);
  const Lanes normalScale = __builtin_sqrt(normalScaleSquared);
  const Real* position = b.position;
  Real curvatures[blockLanes], folds[blockLanes], depths[blockLanes];  // 1/R², (ε R²)², γ δ
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Lanes curvature = load(inverseRadiusSquared + lane), fold = foldedNormal / curvature;
    store(curvatures + lane, curvature);
    store(folds + lane, fold * fold);
    store(depths + lane, surfaceDepth * load(b.sag + lane));
  }
  for (int v = 0; v < mesh.vertexCount; ++v) {
    const RingStep* ring = mesh.ring + mesh.ringStart[v];
    const int neighbours = mesh.neighbours(v);
    const Lanes share = retreat / neighbours;
    prefetch<ofRows>(rows, (v + linesAhead) * ofRows);
    prefetch<ofReference>(reference.place, (v + linesAhead) * ofReference);
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec x = loadVec(b.position, v, lane), w = loadVec(b.predicted, v, lane), g = loadVec(b.gradient, v, lane);
      Vec around = loadVec(position + ring[0].vertexOffset + lane);
      for (int k = 1; k < neighbours; ++k) around += loadVec(position + ring[k].vertexOffset + lane);
      const Lanes curvature = load(curvatures + lane);
      const Vec n = (normalScale / sqrt(dot(g, g) + load(folds + lane))) * g;
      const Vec y = ((1.0 - retreat) * x + share * around) - load(depths + lane) * n;
      const int row = v * blockLanes + lane;
      if constexpr (counting)
        maxChanged =
            max(countChange(count, row, loadRows(rows + row, consecutive), {y, n, asStored(w), curvature}), maxChanged);
      storeRows(rows + row, {y, n, w, curvature});
      const Vec moved = y - loadVec(reference, v, lane);
      farthest = max(select(curvature > Lanes(0.0), dot(moved, moved), 0.0), farthest);
    }
  }
  if constexpr (counting)  // room for the rounding of floats
    if (any(maxChanged > Lanes(0.999999 * count.margin))) findEnded(count, mesh.vertexCount * blockLanes, b.liveLanes);
  return largestOf(farthest);
}

/// Clears the scratch of a block's surface.
MORULA_INLINE void clearSurface(const BlockSlices& block) {
  const std::size_t bytes = std::size_t(block.mesh.vertexCount) * vertexStride * sizeof(Real);
  __builtin_memset(static_cast<Real*>(block.surfaceForce), 0, bytes);
  __builtin_memset(static_cast<Real*>(block.surfaceTurn), 0, bytes);
}

/// γ δ of a block's cells.
struct SurfaceDepths {
  explicit SurfaceDepths(const BlockSlices& block) {
    for (int lane = 0; lane < blockLanes; lane += width) store(value + lane, surfaceDepth * load(block.sag + lane));
  }
  MORULA_INLINE Lanes of(const VertexNumber* vertex) const {
    Real own[width];
    for (int i = 0; i < width; ++i) own[i] = value[static_cast<std::uint32_t>(vertex[i]) % blockLanes];
    return load(own);
  }
  Real value[blockLanes];
};

/// Stores f and t of `width` vertices, lane by lane; the far row (number `vertices`) has no place.
MORULA_INLINE void storeOnSurface(const BlockSlices& block, const SurfaceDepths& depths, const VertexNumber* vertex,
                                  std::int32_t vertices, const Rows& row, const SurfaceForce& sum) {
  const Lanes left = max(normalScaleSquared - dot(row.n, row.n), Lanes(0.0));          // ν² (1 − n²/ν²)
  const Lanes inverse = sqrt(left) * (row.inverseRadiusSquared * (1 / foldedNormal));  // ν/√…
  const Vec q = sum.turn - depths.of(vertex) * sum.force;
  const Vec turn = inverse * (q - (1 / normalScaleSquared) * dot(row.n, q) * row.n);
  Real f[3][width], t[3][width];
  store(f[0], sum.force.x), store(f[1], sum.force.y), store(f[2], sum.force.z);
  store(t[0], turn.x), store(t[1], turn.y), store(t[2], turn.z);
  for (int i = 0; i < width; ++i) {
    if (vertex[i] >= vertices) continue;
    const auto v = static_cast<std::uint32_t>(vertex[i] - block.firstVertex);  // dividing it by eight is a shift
    const std::size_t at = std::size_t(v / blockLanes) * vertexStride + v % blockLanes;
    Real *force = static_cast<Real*>(block.surfaceForce) + at, *couple = static_cast<Real*>(block.surfaceTurn) + at;
    for (int c = 0; c < 3; ++c) force[c * blockLanes] = f[c][i], couple[c * blockLanes] = t[c][i];
  }
}

/// Returns the force on a vertex from its ring. gcc would unroll a loop of known length, keep the addresses of all its
/// steps, and spill them. Neighbours' positions are loaded twice, since registers are too few to keep them.
MORULA_INLINE Vec ringForce(const Real* position, const Real* forces, const Real* turns, const RingStep* ring,
                            const double* share, int steps) {
  Vec sum{Lanes(0.0), Lanes(0.0), Lanes(0.0)}, fromRing = sum;
  std::int64_t before = ring[steps - 1].vertexOffset, here = ring[0].vertexOffset;
#pragma GCC unroll 1
  for (int k = 0; k < steps; ++k) {
    const std::int64_t next = ring[k + 1 < steps ? k + 1 : 0].vertexOffset;
    fromRing += Lanes(share[k]) * loadVec(forces + here);
    sum += cross(loadVec(position + before) - loadVec(position + next), loadVec(turns + here));
    before = here;
    here = next;
  }
  return sum + Lanes(retreat) * fromRing;
}

/// Adds the vertices' forces F to `force` [all blocks].
MORULA_INLINE void moveToVertices(const BlockSlices& block, Real* force) {
  const TemplateView& mesh = block.mesh;
  const Real *position = block.position, *forces = block.surfaceForce, *turns = block.surfaceTurn;
  force += std::size_t(block.firstVertex / blockLanes) * vertexStride;
  for (int v = 0; v < mesh.vertexCount; ++v) {
    const int first = mesh.ringStart[v], steps = mesh.ringStart[v + 1] - first;
    for (int lane = 0; lane < block.liveLanes; lane += width) {
      const Vec around = ringForce(position + lane, forces + lane, turns + lane, mesh.ring + first,
                                   mesh.ringShare + first, steps);
      storeVec(force, v, lane, loadVec(force, v, lane) + ((1.0 - retreat) * loadVec(forces, v, lane) + around));
    }
  }
}

}  // namespace morula::MORULA_ISA

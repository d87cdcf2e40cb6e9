#pragma once
// Where a round shell holds surfaces: not a cell's vertices, but the surface that holds the cell's volume. Where the
// cell lies against the shell, that surface is by
//
//   δ = ⅛ κ(d) averaged over the ring's edges d [length],   κ(d) = dᵀAd/|s|,   A = diag(1/a_i²),  s = A x
//
// below each vertex, y = x − δ s/|s|, where κ(d)/2 is how far the shell bends away along d. For a sphere of radius R:
// δ = l²/8R, and a mesh with vertices at R and edges of length l around it encloses as much as the ball of radius
// R − l²/8R. A shell that holds the vertices lacks room for the difference. That error is of second order in l,
// and large: 162 vertices in a shell that is a little too small for them have a pressure of 15 where 8.8 is right.
//
// δ is found when all vertices have moved and before any is put back, so their order cannot matter, and nothing is
// kept from step to step. It follows from the shell's curvature, not from the cell's: that would be −¼ (mean(ring) −
// x)·n, by which a vertex that moves out takes δ with it and never comes to rest. What the shell does to y it does to
// x: it moves it as far, and takes the same velocity. After the kick it bears what presses on the same y.
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

// [1] of δ: so close to the shell y is borne, too. Where the surface still slides δ changes a little from step to
// step, and what is let go for a step and caught again would never come to rest.
constexpr double borneWithin = 2e-3;

MORULA_INLINE Vec select(Mask where, const Vec& a, const Vec& b) {
  return {select(where, a.x, b.x), select(where, a.y, b.y), select(where, a.z, b.z)};
}

/// x − y
MORULA_INLINE Vec sagOf(const ShellSlope& slope, const TemplateView& mesh, const Real* position, int v, const Vec& x) {
  const RingStep* ring = mesh.ring + mesh.ringStart[v];
  const int neighbours = mesh.neighbours(v);
  Lanes sum = 0.0;
  for (int k = 0; k < neighbours; ++k) {
    const Vec d = loadVec(position + ring[k].vertexOffset) - x;
    sum += dot(d, slope(d));
  }
  const Vec s = slope(x);
  return (Lanes(0.125 / neighbours) * sum / dot(s, s)) * s;
}

/// After the drift. Of vertices within the shell in all lanes nothing is written.
inline void keepSurfaces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p) {
  Real *position = b.position, *held = b.held, *velocities = b.velocity, *predictions = b.predicted;
  std::int32_t* vertices = b.heldVertices;
  const int liveLanes = b.liveLanes;
  const ShellSlope slope(p);
  const auto isNear = [&](const Vec& x) MORULA_INLINE_LAMBDA { return isOnShell(x, slope(x)); };
  int near = 0;
  for (int v = 0; v < mesh.vertexCount; ++v) {
    bool isAny = false;
    for (int lane = 0; lane < liveLanes; lane += width) isAny |= any(isNear(loadVec(position, v, lane)));
    vertices[near] = v;
    near += isAny;
  }
  *b.heldCount = near;
  for (int i = 0; i < near; ++i) {
    const int v = vertices[i];
    for (int lane = 0; lane < liveLanes; lane += width) {
      const Vec x = loadVec(position, v, lane);
      const Mask isHere = isNear(x);
      storeVec(held, v, lane, any(isHere) ? select(isHere, x - sagOf(slope, mesh, position + lane, v, x), x) : x);
    }
  }
  for (int i = 0; i < near; ++i) {
    const int v = vertices[i];
    for (int lane = 0; lane < liveLanes; lane += width) {
      const Vec x = loadVec(position, v, lane);
      Vec y = loadVec(held, v, lane);
      const Vec sag = x - y;
      if (!any(isNear(y + Lanes(borneWithin) * sag))) continue;
      if (const Mask outside = dot(y, slope(y)) > Lanes(1.0); any(outside)) {
        Vec velocity = loadVec(velocities, v, lane), predicted = loadVec(predictions, v, lane);
        keepInShell<ShellShape::ellipsoid>(slope, y, velocity, predicted);
        storeVec(position, v, lane, select(outside, y + sag, x));
        storeVec(velocities, v, lane, velocity);
        storeVec(predictions, v, lane, predicted);
      }
      storeVec(held, v, lane, y + Lanes(borneWithin) * sag);
    }
  }
}

/// A drift without a shell, and then the shell.
template <auto drift>
inline void driftAroundSurfaces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  drift(mesh, b, p, dt);
  keepSurfaces(mesh, b, p);
}

/// A kick without a shell, and then the shell bears what presses against it.
template <auto kick>
inline void kickAroundSurfaces(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  kick(mesh, b, p, dt);
  const ShellSlope slope(p);
  for (int i = 0; i < *b.heldCount; ++i) {
    const int v = b.heldVertices[i];
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec y = loadVec(b.held, v, lane);
      if (!any(isOnShell(y, slope(y)))) continue;
      Vec velocity = loadVec(b.velocity, v, lane), acceleration = loadVec(b.acceleration, v, lane);
      slideOnShell(slope, y, velocity, acceleration);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.acceleration, v, lane, acceleration);
    }
  }
}

}  // namespace morula::MORULA_ISA

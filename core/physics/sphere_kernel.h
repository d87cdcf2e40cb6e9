#pragma once
// The sphere: a cell of one vertex, its centre, with a radius that only growth and division change.
//
// No force acts inside of a sphere, so one kernel stands where other models have springs, rings and pressure. Its
// centre feels the shell with half-axes shortened by its radius, as a mesh's vertices feel the shell itself. Exact in a
// spherical shell; in an ellipsoid the sphere stands out a little where the shell bends.
#include <numbers>

#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

/// acceleration ← 0, or with drag −drag·m·w; volume ← 4π/3 r³; pressure ← 0.
template <bool dragged>
inline void measureSpheres(const TemplateView&, const BlockView& b, const KernelParameters& p) {
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    const Lanes r = p.radius * load(b.restScale + lane);
    store(b.volume + lane, (4 * std::numbers::pi / 3) * (r * r * r));
    store(b.pressure + lane, Lanes(0.0));
    Vec force{Lanes(0.0), Lanes(0.0), Lanes(0.0)};
    if constexpr (dragged) force -= (p.drag * load(b.vertexMass + lane)) * loadVec(b.predicted, 0, lane);
    storeVec(b.acceleration, 0, lane, force);
  }
}

/// Returns the shell as the centres of spheres feel it.
MORULA_INLINE FeltShell shellOfSpheres(const BlockView& b, const KernelParameters& p, int lane) {
  return FeltShell(p, -p.radius * load(b.restScale + lane));
}

/// Runs a drift, then keeps the centres in the shell.
template <auto drift>
inline void driftSpheres(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  drift(mesh, b, p, dt);
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    Vec x = loadVec(b.position, 0, lane), velocity = loadVec(b.velocity, 0, lane),
        predicted = loadVec(b.predicted, 0, lane);
    keepInShell<ShellShape::ellipsoid>(shellOfSpheres(b, p, lane), x, velocity, predicted);
    storeVec(b.position, 0, lane, x);
    storeVec(b.velocity, 0, lane, velocity);
    storeVec(b.predicted, 0, lane, predicted);
  }
}

/// Runs a kick; then the shell bears the forces against it.
template <auto kick>
inline void kickSpheres(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  kick(mesh, b, p, dt);
  for (int lane = 0; lane < b.liveLanes; lane += width) {
    Vec velocity = loadVec(b.velocity, 0, lane), acceleration = loadVec(b.acceleration, 0, lane);
    slideOnShell(shellOfSpheres(b, p, lane), loadVec(b.position, 0, lane), velocity, acceleration);
    storeVec(b.velocity, 0, lane, velocity);
    storeVec(b.acceleration, 0, lane, acceleration);
  }
}

}  // namespace morula::MORULA_ISA

#pragma once
// The two Euler methods, first order, one evaluation of the forces per step.
//
//   explicit [Nilsson 2008, eq. 3.12]:    x' = x + Δt v,  v' = v + Δt a(x, v)     gains energy at every step
//   symplectic (semi-implicit):           x' = x + Δt v,  v' = v + Δt a(x', v)    keeps it, up to a ripple
//
// The thesis' Verlet (verlet_kernel.h) is the symplectic method in its other order, velocities first.
#include "physics/parameters.h"
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

/// x ← x', velocity and predicted ← v'; and the shell keeps what would leave it. The kick only ends the
/// evaluation.
template <ShellShape shell>
inline void driftExplicitEuler(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                               double dt) {
  const Lanes step = dt;
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec before = loadVec(b.velocity, v, lane);
      Vec velocity = before + step * loadVec(b.acceleration, v, lane), predicted = velocity;
      Vec x = loadVec(b.position, v, lane) + step * before;
      if constexpr (shell != ShellShape::none) keepInShell<shell>(slope, x, velocity, predicted);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.predicted, v, lane, predicted);
      storeVec(b.position, v, lane, x);
    }
}

/// x ← x', predicted ← v, which a whole kick turns into v'.
template <ShellShape shell>
inline void driftSymplecticEuler(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                                 double dt) {
  const Lanes step = dt;
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec velocity = loadVec(b.velocity, v, lane), predicted = velocity;
      Vec x = loadVec(b.position, v, lane) + step * velocity;
      if constexpr (shell != ShellShape::none) keepInShell<shell>(slope, x, velocity, predicted);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.predicted, v, lane, predicted);
      storeVec(b.position, v, lane, x);
    }
}

}  // namespace morula::MORULA_ISA

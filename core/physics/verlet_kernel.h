#pragma once
// Time integration, in two halves around the forces.
//
// Velocity Verlet, second order [Swope et al. 1982]:
//   drift:  v½ = v + ½Δt a,   x' = x + Δt v½            kick:  v' = v½ + ½Δt a'
// with damping forces taken at the prediction w = v½ + ½Δt a = v + Δt a, which is good to Δt² and keeps the
// order.
//
// The thesis' Verlet, x' = 2x − x_prev + a Δt² [Nilsson 2008, eq. 4.6], written with its velocity v = (x −
// x_prev)/Δt [eq. 4.7]: v' = v + Δt a, x' = x + Δt v'. Damping sees that lagged velocity: first order.
#include "physics/shell_kernel.h"

namespace morula::MORULA_ISA {

/// x ← x', velocity ← v½, predicted ← w; and the shell keeps what would leave it.
template <ShellShape shell>
inline void driftVelocityVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                                double dt) {
  const Lanes halfStep = 0.5 * dt, step = dt;
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const Vec impulse = halfStep * loadVec(b.acceleration, v, lane);
      Vec half = loadVec(b.velocity, v, lane) + impulse, predicted = half + impulse;
      Vec x = loadVec(b.position, v, lane) + step * half;
      if constexpr (shell != ShellShape::none) keepInShell<shell>(slope, x, half, predicted);
      storeVec(b.velocity, v, lane, half);
      storeVec(b.predicted, v, lane, predicted);
      storeVec(b.position, v, lane, x);
    }
}

/// The same for the thesis' Verlet: x ← x', velocity and predicted ← v'.
template <ShellShape shell>
inline void driftThesisVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters& p,
                              double dt) {
  const Lanes step = dt;
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec velocity = loadVec(b.velocity, v, lane) + step * loadVec(b.acceleration, v, lane),
          predicted = velocity;
      Vec x = loadVec(b.position, v, lane) + step * velocity;
      if constexpr (shell != ShellShape::none) keepInShell<shell>(slope, x, velocity, predicted);
      storeVec(b.velocity, v, lane, velocity);
      storeVec(b.predicted, v, lane, predicted);
      storeVec(b.position, v, lane, x);
    }
}

struct InverseMass {
  explicit InverseMass(const BlockView& b) {
    for (int lane = 0; lane < blockLanes; lane += width) store(value + lane, 1.0 / load(b.vertexMass + lane));
  }
  Real value[blockLanes];
};

/// How much of a time step the velocity still lacks when the new acceleration is known.
enum class Kick { none, half, whole };

/// Force → acceleration, and velocity ← v' where the drift has left some of it. The shell bears what presses
/// against it.
template <Kick lacking, bool shell>
inline void kick(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const Lanes step = lacking == Kick::half ? 0.5 * dt : dt;
  const InverseMass inverseMass(b);
  const ShellSlope slope(p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec a = load(inverseMass.value + lane) * loadVec(b.acceleration, v, lane);
      Vec velocity;
      if constexpr (lacking != Kick::none || shell) velocity = loadVec(b.velocity, v, lane);
      if constexpr (lacking != Kick::none) velocity += step * a;
      if constexpr (shell) slideOnShell(slope, loadVec(b.position, v, lane), velocity, a);
      if constexpr (lacking != Kick::none || shell) storeVec(b.velocity, v, lane, velocity);
      storeVec(b.acceleration, v, lane, a);
    }
}

}  // namespace morula::MORULA_ISA

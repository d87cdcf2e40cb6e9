#pragma once
// Time integration, in two halves around the forces.
//
// Velocity Verlet, second order [Swope et al. 1982]:
//   drift:  v½ = v + ½Δt a,   x' = x + Δt v½            kick:  v' = v½ + ½Δt a'
// with damping forces taken at the prediction w = v½ + ½Δt a = v + Δt a, which is good to Δt² and keeps the order.
//
// The thesis' Verlet, x' = 2x − x_prev + a Δt² [Nilsson 2008, eq. 4.6], written with its velocity
// v = (x − x_prev)/Δt [eq. 4.7]:
//   v' = v + Δt a,   x' = x + Δt v'
// Damping sees that lagged velocity: first order.
#include "physics/drift_kernel.h"

namespace morula::MORULA_ISA {

/// Drifts one vertex: x ← x', velocity ← v½, predicted ← w.
MORULA_INLINE void driftVertex(Lanes halfStep, Lanes step, const Vec& acceleration, Vec& x, Vec& velocity,
                               Vec& predicted) {
  const Vec impulse = halfStep * acceleration;
  velocity += impulse;
  predicted = velocity + impulse;
  x += step * velocity;
}

template <ShellShape shell>
inline void driftVelocityVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const Lanes halfStep = 0.5 * dt, step = dt;
  driftVertices<shell>(mesh, b, p,
                       [=](int, int, const Vec& a, Vec& x, Vec& velocity, Vec& predicted)
                           MORULA_INLINE_LAMBDA { driftVertex(halfStep, step, a, x, velocity, predicted); });
}

/// x ← x', velocity and predicted ← v'.
template <ShellShape shell>
inline void driftThesisVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const Lanes step = dt;
  driftVertices<shell>(mesh, b, p,
                       [=](int, int, const Vec& a, Vec& x, Vec& velocity, Vec& predicted) MORULA_INLINE_LAMBDA {
                         predicted = velocity = velocity + step * a;
                         x = x + step * velocity;
                       });
}

struct InverseMass {
  explicit InverseMass(const BlockView& b) {
    for (int lane = 0; lane < blockLanes; lane += width) store(value + lane, 1.0 / load(b.vertexMass + lane));
  }
  Real value[blockLanes];
};

/// The part of a time step that the velocity still lacks when the new acceleration is known.
enum class Kick { none, half, whole };

/// Kicks one vertex: returns the acceleration of a force, and velocity ← v' where the drift has left part of the step.
/// The shell bears the force against it.
template <Kick lacking, bool shell, class Slope>
MORULA_INLINE Vec kickVertex(const Slope& slope, Lanes inverseMass, Lanes step, const Vec& force, const Vec& x,
                             Vec& velocity) {
  Vec a = inverseMass * force;
  if constexpr (lacking != Kick::none) velocity += step * a;
  if constexpr (shell) slideOnShell(slope, x, velocity, a);
  return a;
}

/// Turns force into acceleration, for all vertices.
template <Kick lacking, ShellShape shape>
inline void kick(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  constexpr bool shell = shape != ShellShape::none;
  constexpr bool moves = lacking != Kick::none || shell;
  const Lanes step = lacking == Kick::half ? 0.5 * dt : dt;
  const InverseMass inverseMass(b);
  const BlockShell<shape> felt(b, p);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0, group = 0; lane < b.liveLanes; lane += width, ++group) {
      Vec x, velocity;
      if constexpr (shell) x = loadVec(b.position, v, lane);
      if constexpr (moves) velocity = loadVec(b.velocity, v, lane);
      const Vec a = kickVertex<lacking, shell>(felt[group], load(inverseMass.value + lane), step,
                                               loadVec(b.acceleration, v, lane), x, velocity);
      if constexpr (moves) storeVec(b.velocity, v, lane, velocity);
      storeVec(b.acceleration, v, lane, a);
    }
}

}  // namespace morula::MORULA_ISA

#pragma once
// Time integration, in two halves around the forces.
//
// Velocity Verlet, second order [Swope et al. 1982]:
//   drift:  v½ = v + ½Δt a,   x' = x + Δt v½            kick:  v' = v½ + ½Δt a'
// with damping forces taken at the prediction w = v½ + ½Δt a = v + Δt a, which is good to Δt² and keeps the
// order.
//
// The thesis' Verlet, x' = 2x − x_prev + a Δt² [Nilsson 2008, eq. 4.6], written with its velocity
// v = (x − x_prev)/Δt [eq. 4.7]:
//   v' = v + Δt a,   x' = x + Δt v'
// Damping sees that lagged velocity: first order.
#include "physics/drift_kernel.h"

namespace morula::MORULA_ISA {

/// One vertex: x ← x', velocity ← v½, predicted ← w.
MORULA_INLINE void driftVertex(Lanes halfStep, Lanes step, const Vec& acceleration, Vec& x, Vec& velocity,
                               Vec& predicted) {
  const Vec impulse = halfStep * acceleration;
  velocity += impulse;
  predicted = velocity + impulse;
  x += step * velocity;
}

inline void driftVelocityVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&,
                                double dt) {
  const Lanes halfStep = 0.5 * dt, step = dt;
  driftVertices(mesh, b,
                [=](int, int, const Vec& a, Vec& x, Vec& velocity, Vec& predicted)
                    MORULA_INLINE_LAMBDA { driftVertex(halfStep, step, a, x, velocity, predicted); });
}

/// x ← x', velocity and predicted ← v'.
inline void driftThesisVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&,
                              double dt) {
  const Lanes step = dt;
  driftVertices(mesh, b,
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

/// How much of a time step the velocity still lacks when the new acceleration is known.
enum class Kick { none, half, whole };

/// One vertex: the acceleration of a force, and velocity ← v' where the drift has left some of it.
template <Kick lacking>
MORULA_INLINE Vec kickVertex(Lanes inverseMass, Lanes step, const Vec& force, Vec& velocity) {
  const Vec a = inverseMass * force;
  if constexpr (lacking != Kick::none) velocity += step * a;
  return a;
}

/// Force → acceleration, of all vertices.
template <Kick lacking>
inline void kick(const TemplateView& mesh, const BlockView& b, const KernelParameters&, double dt) {
  constexpr bool moves = lacking != Kick::none;
  const Lanes step = lacking == Kick::half ? 0.5 * dt : dt;
  const InverseMass inverseMass(b);
  for (int v = 0; v < mesh.vertexCount; ++v)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      Vec velocity;
      if constexpr (moves) velocity = loadVec(b.velocity, v, lane);
      const Vec a = kickVertex<lacking>(load(inverseMass.value + lane), step,
                                        loadVec(b.acceleration, v, lane), velocity);
      if constexpr (moves) storeVec(b.velocity, v, lane, velocity);
      storeVec(b.acceleration, v, lane, a);
    }
}

}  // namespace morula::MORULA_ISA

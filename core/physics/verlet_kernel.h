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
#include "base/lanes.h"
#include "physics/block.h"

namespace morula::MORULA_ISA {

/// x ← x', velocity ← v½, predicted ← w.
inline void driftVelocityVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&,
                                double dt) {
  const Lanes halfStep = 0.5 * dt, step = dt;
  Real *position = b.position, *velocity = b.velocity, *predicted = b.predicted,
       *acceleration = b.acceleration;
  const int lines = 3 * mesh.vertexCount;
  for (int i = 0; i < lines; ++i)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const int at = i * blockLanes + lane;
      const Lanes impulse = halfStep * load(acceleration + at);
      const Lanes half = load(velocity + at) + impulse;
      store(velocity + at, half);
      store(predicted + at, half + impulse);
      store(position + at, load(position + at) + step * half);
    }
}

struct InverseMass {
  explicit InverseMass(const BlockView& b) {
    for (int lane = 0; lane < blockLanes; lane += width) store(value + lane, 1.0 / load(b.vertexMass + lane));
  }
  Real value[blockLanes];
};

/// Force → acceleration, velocity ← v'.
inline void kickVelocityVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&,
                               double dt) {
  const Lanes halfStep = 0.5 * dt;
  const InverseMass inverseMass(b);
  Real *velocity = b.velocity, *acceleration = b.acceleration;
  const int lines = 3 * mesh.vertexCount;
  for (int i = 0; i < lines; ++i)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const int at = i * blockLanes + lane;
      const Lanes a = load(acceleration + at) * load(inverseMass.value + lane);
      store(acceleration + at, a);
      store(velocity + at, load(velocity + at) + halfStep * a);
    }
}

/// x ← x', velocity and predicted ← v'.
inline void driftThesisVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&,
                              double dt) {
  const Lanes step = dt;
  Real *position = b.position, *velocity = b.velocity, *predicted = b.predicted,
       *acceleration = b.acceleration;
  const int lines = 3 * mesh.vertexCount;
  for (int i = 0; i < lines; ++i)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const int at = i * blockLanes + lane;
      const Lanes v = load(velocity + at) + step * load(acceleration + at);
      store(velocity + at, v);
      store(predicted + at, v);
      store(position + at, load(position + at) + step * v);
    }
}

/// Force → acceleration.
inline void kickThesisVerlet(const TemplateView& mesh, const BlockView& b, const KernelParameters&, double) {
  const InverseMass inverseMass(b);
  Real* acceleration = b.acceleration;
  const int lines = 3 * mesh.vertexCount;
  for (int i = 0; i < lines; ++i)
    for (int lane = 0; lane < b.liveLanes; lane += width) {
      const int at = i * blockLanes + lane;
      store(acceleration + at, load(acceleration + at) * load(inverseMass.value + lane));
    }
}

}  // namespace morula::MORULA_ISA

#pragma once
// The two Euler methods, first order, one evaluation of the forces per step.
//
//   explicit [Nilsson 2008, eq. 3.12]:    x' = x + Δt v,  v' = v + Δt a(x, v)     gains energy at every step
//   symplectic (semi-implicit):           x' = x + Δt v,  v' = v + Δt a(x', v)    keeps it, up to a ripple
//
// The thesis' Verlet (verlet_kernel.h) is the symplectic method in its other order, velocities first.
#include "physics/drift_kernel.h"

namespace morula::MORULA_ISA {

/// x ← x', velocity and predicted ← v'. The kick only ends the evaluation.
template <ShellShape shell>
inline void driftExplicitEuler(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const Lanes step = dt;
  driftVertices<shell>(mesh, b, p,
                       [=](int, int, const Vec& a, Vec& x, Vec& velocity, Vec& predicted) MORULA_INLINE_LAMBDA {
                         x = x + step * velocity;
                         predicted = velocity = velocity + step * a;
                       });
}

/// x ← x', predicted ← v, which a whole kick turns into v'.
template <ShellShape shell>
inline void driftSymplecticEuler(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const Lanes step = dt;
  driftVertices<shell>(mesh, b, p,
                       [=](int, int, const Vec&, Vec& x, Vec& velocity, Vec& predicted) MORULA_INLINE_LAMBDA {
                         predicted = velocity;
                         x = x + step * velocity;
                       });
}

}  // namespace morula::MORULA_ISA

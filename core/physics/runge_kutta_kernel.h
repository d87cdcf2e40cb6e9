#pragma once
// The classical Runge–Kutta method, fourth order, four evaluations of the forces per step [Kutta 1901]. With
// y = (x, v) and its slope k = (v, a):
//
//   y₂ = y + ½Δt k₁,   y₃ = y + ½Δt k₂,   y₄ = y + Δt k₃,   y' = y + Δt/6 (k₁ + 2k₂ + 2k₃ + k₄)
//
// k₁ stands in velocity and acceleration when a step begins, because the step before has ended with the evaluation at
// its y'. So drift number s = 1 … 4 finds k_s and leaves y_{s+1} or y' to be evaluated; the kick only ends the
// evaluation. The shell acts at each of the four.
#include "physics/drift_kernel.h"

namespace morula::MORULA_ISA {

template <int s, ShellShape shell>
inline void driftRungeKutta(const TemplateView& mesh, const BlockView& b, const KernelParameters& p, double dt) {
  const int whole = mesh.vertexCount * vertexStride;
  Real* x0 = b.substeps;
  Real *v0 = x0 + whole, *sumOfVelocities = v0 + whole, *sumOfAccelerations = sumOfVelocities + whole;
  const Lanes step = s <= 2 ? 0.5 * dt : s == 3 ? dt : dt / 6, twice = 2.0;
  driftVertices<shell>(mesh, b, p,
                       [=](int v, int lane, const Vec& acceleration, Vec& x, Vec& velocity, Vec& predicted)
                           MORULA_INLINE_LAMBDA {
                             Vec u = velocity, a = acceleration;
                             if constexpr (s == 1) {
                               storeVec(x0, v, lane, x);
                               storeVec(v0, v, lane, u);
                               storeVec(sumOfVelocities, v, lane, u);
                               storeVec(sumOfAccelerations, v, lane, a);
                             } else if constexpr (s == 4) {
                               u += loadVec(sumOfVelocities, v, lane);
                               a += loadVec(sumOfAccelerations, v, lane);
                             } else {
                               storeVec(sumOfVelocities, v, lane, loadVec(sumOfVelocities, v, lane) + twice * u);
                               storeVec(sumOfAccelerations, v, lane, loadVec(sumOfAccelerations, v, lane) + twice * a);
                             }
                             x = loadVec(x0, v, lane) + step * u;
                             predicted = velocity = loadVec(v0, v, lane) + step * a;
                           });
}

}  // namespace morula::MORULA_ISA

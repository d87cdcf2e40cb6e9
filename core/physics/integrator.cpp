#include "physics/integrator.h"

#include <algorithm>
#include <cmath>

namespace morula {
namespace {

/// A damped oscillator k, c, m alternates without end where ω²Δt² + 4γΔt = 4 in velocity Verlet (s = 2), whose
/// damping sees the velocity predicted from the last acceleration, and where ω²Δt² + 2γΔt = 4 in the thesis'
/// Verlet and symplectic Euler (s = 1), with ω² = k/m and γ = c/m: the positive root of
///   k Δt² + 2sc Δt − 4m = 0.
/// Written so that k = 0 is no trouble.
template <int s>
double verletLimit(double k, double c, double m) {
  const double sc = s * c;
  return 4 * m / (std::sqrt(sc * sc + 4 * k * m) + sc);
}

/// Returns true if Runge–Kutta of this order, 1 or 4, lets no solution of x'' + b x' + a x = 0 grow in a step of 1.
/// Its amplification R(z) = Σ zⁿ/n! up to the order, at both roots z of z² + b z + a = 0, is p + q z there;
/// both |R| ≤ 1 if ΠR ≤ 1, Π(1 − R) ≥ 0 and Π(1 + R) ≥ 0.
bool isStable(int order, double a, double b) {
  double p = 1, q = 1;
  if (order == 4) {
    p += -a / 2 + a * b / 6 + a * (a - b * b) / 24;
    q += -b / 2 + (b * b - a) / 6 + b * (2 * a - b * b) / 24;
  }
  const auto product = [&](double r) { return r * r - r * q * b + q * q * a; };  // Π(r + q z)
  return product(p) <= 1 && product(p - 1) >= 0 && product(p + 1) >= 0;
}

/// Finds the stability limit by bisection: both regions of stability are without gaps on the way from 0 to their
/// border, and within 4 of 0. An undamped oscillator gives 0 for order 1, which is explicit Euler.
template <int order>
double rungeKuttaLimit(double k, double c, double m) {
  const double a = k / m, b = c / m;
  const double fastest = std::max(std::sqrt(a), b / 2);  // at most the larger |z|
  if (!(fastest > 0)) return INFINITY;
  double low = 0, high = 4 / fastest;
  for (int i = 0; i < 60; ++i) {
    const double h = 0.5 * (low + high);
    (isStable(order, h * h * a, h * b) ? low : high) = h;
  }
  return low;
}

using Kernels = const PhysicsKernels&;
Movement moveByVelocityVerlet(Kernels k, int s, bool) { return {k.driftVelocityVerlet[s], {}, k.kickVelocityVerlet}; }
Movement moveByThesisVerlet(Kernels k, int s, bool) { return {k.driftThesisVerlet[s], {}, k.endEvaluation}; }
Movement moveByExplicitEuler(Kernels k, int s, bool) { return {k.driftExplicitEuler[s], {}, k.endEvaluation}; }
Movement moveBySymplecticEuler(Kernels k, int s, bool) {
  return {k.driftSymplecticEuler[s], {}, k.kickSymplecticEuler};
}
Movement moveByRungeKutta(Kernels k, int s, bool) {
  return {k.driftRungeKutta[s][0], std::span(k.driftRungeKutta[s]).subspan(1), k.endEvaluation};
}
Movement moveByXpbd(Kernels k, int s, bool damped) { return {k.driftXpbd[damped][s], {}, k.endEvaluation}; }

// Rows stand in the order of the enumeration's values.
constexpr IntegratorKind kinds[] = {
    {.title = "velocity Verlet", .order = 2, .oscillatorLimit = verletLimit<2>, .movement = moveByVelocityVerlet},
    {.title = "the thesis' Verlet", .order = 1, .oscillatorLimit = verletLimit<1>, .movement = moveByThesisVerlet},
    {.title = "explicit Euler",
     .order = 1,
     .needsDrag = true,
     .oscillatorLimit = rungeKuttaLimit<1>,
     .undampedLimit = 0,
     .movement = moveByExplicitEuler},
    {.title = "symplectic Euler", .order = 1, .oscillatorLimit = verletLimit<1>, .movement = moveBySymplecticEuler},
    {.title = "Runge-Kutta of fourth order",
     .order = 4,
     .evaluations = 4,
     .oscillatorLimit = rungeKuttaLimit<4>,
     .undampedLimit = 2.8284271247461903,  // √8
     .movement = moveByRungeKutta},
    // XPBD takes contact forces once per time step, whatever its sub-steps, as symplectic Euler does.
    {.title = "position-based dynamics",
     .order = 1,
     .solvesForces = true,
     .oscillatorLimit = verletLimit<1>,
     .movement = moveByXpbd},
    // The limits of one evaluation's motion are those of a time step without damping.
    {.title = "quasi-static growth",
     .order = 0,
     .settles = true,
     .oscillatorLimit = verletLimit<1>,
     .movement = moveBySymplecticEuler},
};
static_assert(std::size(kinds) == choices<Integrator>.size());

}  // namespace

const IntegratorKind& kindOf(Integrator integrator) { return kinds[static_cast<int>(integrator)]; }

}  // namespace morula

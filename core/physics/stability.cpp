#include "physics/stability.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "mesh/measures.h"

namespace morula {

namespace {

/// A damped oscillator k, c, m alternates without end where ω²Δt² + 4γΔt = 4 in velocity Verlet, whose
/// damping sees the velocity predicted from the last acceleration, and where ω²Δt² + 2γΔt = 4 in the thesis'
/// Verlet and symplectic Euler, with ω² = k/m and γ = c/m: the positive root of k Δt² + 2sc Δt − 4m = 0 with
/// s = 2 and s = 1. Written so that k = 0 is no trouble.
double verletLimit(Integrator integrator, double k, double c, double m) {
  const double sc = integrator == Integrator::velocityVerlet ? 2 * c : c;
  return 4 * m / (std::sqrt(sc * sc + 4 * k * m) + sc);
}

/// Whether Runge–Kutta of that order, 1 or 4, lets no solution of x'' + b x' + a x = 0 grow in a step of 1.
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

/// By bisection: both regions of stability are without gaps on the way from 0 to their border, and within 4
/// of 0. An undamped oscillator gives 0 for order 1.
double rungeKuttaLimit(int order, double k, double c, double m) {
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

/// Of all but explicit Euler.
double oscillatorLimit(Integrator integrator, double k, double c, double m) {
  if (integrator == Integrator::rungeKutta4) return rungeKuttaLimit(4, k, c, m);
  return verletLimit(integrator, k, c, m);
}

/// Explicit Euler's, which drag alone keeps from 0 [stability.h].
StabilityLimits limitsByDamping(const Bodies& b, int slot, double radius, double omega) {
  const auto& membrane = b.parameters.membrane;
  const double drag = b.parameters.drag, m = b.vertexMass[slot] / 6;
  const MeshTemplate& mesh = b.meshOf(slot);
  const double atRest = b.restScale[slot] *
                        cubeRoot(3 * measureVolume(mesh.mesh.vertices, mesh.mesh.faces) / 12.566370614359172);
  const double tension = membrane.stiffness * std::max(1 - atRest / radius, 0.0);
  const auto limit = [&](double k, double c) { return drag > 0 ? rungeKuttaLimit(1, k, c, m) : 0; };
  return {std::min(limit(membrane.stiffness, membrane.damping + drag * m), limit(tension, drag * m)),
          drag > 0 ? rungeKuttaLimit(1, omega * omega, drag, 1) : 0};
}

/// The stiffest mode swings fastest; where much is damped the softest, in the direction of β, creeps back
/// fastest.
double shapeLimit(const PhysicsParameters& p) {
  const double k = p.shapeMatching.stiffness, soft = (1 - p.shapeMatching.linear) * k;
  const double c = p.shapeMatching.damping + p.drag;
  if (p.integrator != Integrator::explicitEuler)
    return std::min(oscillatorLimit(p.integrator, k, c, 1), oscillatorLimit(p.integrator, soft, c, 1));
  return c > 0 ? std::min(rungeKuttaLimit(1, k, c, 1), rungeKuttaLimit(1, soft, c, 1)) : 0;
}

}  // namespace

StabilityLimits measureLimits(const Bodies& b, int slot) {
  if (b.parameters.cell.model == CellModel::shapeMatching) return {shapeLimit(b.parameters), INFINITY};
  if (b.areSpheres()) return {INFINITY, INFINITY};  // nothing inside it swings
  const auto& membrane = b.parameters.membrane;
  const double fourPi = 12.566370614359172, volume = b.volume[slot];
  const double radius = cubeRoot(3 * volume / fourPi), area = fourPi * radius * radius;
  const double omega = std::sqrt(b.pressureConstant[slot] / b.mass(slot)) / volume * area;
  if (b.parameters.integrator == Integrator::xpbd) return {INFINITY, INFINITY};
  if (b.parameters.integrator == Integrator::explicitEuler) return limitsByDamping(b, slot, radius, omega);
  return {
      oscillatorLimit(b.parameters.integrator, membrane.stiffness, membrane.damping, b.vertexMass[slot] / 6),
      (b.parameters.integrator == Integrator::rungeKutta4 ? std::sqrt(8.0) : 2) / omega};
}

double dragLimit(Integrator integrator, double drag) {
  if (integrator == Integrator::xpbd) return INFINITY;
  if (integrator == Integrator::explicitEuler) return rungeKuttaLimit(1, 0, drag, 1);
  return oscillatorLimit(integrator, 0, drag, 1);
}

double contactLimit(Integrator integrator, double stiffness, double damping, double vertexMass, double drag) {
  const double m = vertexMass / 10;
  if (integrator != Integrator::explicitEuler) return oscillatorLimit(integrator, stiffness, damping, m);
  return drag > 0 ? rungeKuttaLimit(1, stiffness, damping + drag * m, m) : 0;
}

}  // namespace morula

#include "physics/stability.h"

#include <cmath>

#include "base/maths.h"

namespace morula {

namespace {

/// A damped oscillator k, c, m alternates without end where ω²Δt² + 4γΔt = 4 in velocity Verlet, whose
/// damping sees the velocity predicted from the last acceleration, and where ω²Δt² + 2γΔt = 4 in the thesis'
/// Verlet, with ω² = k/m and γ = c/m: the positive root of k Δt² + 2sc Δt − 4m = 0 with s = 2 and s = 1.
/// Written so that k = 0 is no trouble.
double oscillatorLimit(Integrator integrator, double k, double c, double m) {
  const double sc = integrator == Integrator::velocityVerlet ? 2 * c : c;
  return 4 * m / (std::sqrt(sc * sc + 4 * k * m) + sc);
}

}  // namespace

StabilityLimits measureLimits(const Bodies& b, int slot) {
  const auto& membrane = b.parameters.membrane;
  const double fourPi = 12.566370614359172, volume = b.volume[slot];
  const double radius = cubeRoot(3 * volume / fourPi), area = fourPi * radius * radius;
  const double omega = std::sqrt(b.pressureConstant[slot] / b.mass(slot)) / volume * area;
  return {
      oscillatorLimit(b.parameters.integrator, membrane.stiffness, membrane.damping, b.vertexMass[slot] / 6),
      2 / omega};
}

double contactLimit(Integrator integrator, double stiffness, double damping, double vertexMass) {
  return oscillatorLimit(integrator, stiffness, damping, vertexMass / 10);
}

}  // namespace morula

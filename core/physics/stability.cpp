#include "physics/stability.h"

#include <cmath>

#include "base/maths.h"

namespace morula {

namespace {

/// The positive root of k Δt² + 2 c Δt − 4 m = 0: explicit steps of a damped oscillator with ω² = k/m.
double oscillatorLimit(double k, double c, double m) { return (std::sqrt(c * c + 4 * k * m) - c) / k; }

}  // namespace

StabilityLimits measureLimits(const Bodies& b, int slot) {
  const auto& membrane = b.parameters.membrane;
  const double fourPi = 12.566370614359172, volume = b.volume[slot];
  const double radius = cubeRoot(3 * volume / fourPi), area = fourPi * radius * radius;
  const double omega = std::sqrt(b.pressureConstant[slot] / b.mass(slot)) / volume * area;
  return {oscillatorLimit(membrane.stiffness, membrane.damping, b.vertexMass[slot] / 6), 2 / omega};
}

double contactLimit(double stiffness, double damping, double vertexMass) {
  return oscillatorLimit(stiffness, damping, vertexMass / 4);
}

}  // namespace morula

#include "simulation/rest.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/maths.h"
#include "contacts/contacts.h"

namespace morula {
namespace {

constexpr double minStrain = 0.1;  // [k_s/R] min p̂

/// Returns p̂ [force/length²].
double scale(const World& world, int slot, double radius) {
  const Bodies& bodies = *world.bodies;
  const double stiffness = !bodies.areSpheres() ? bodies.parameters.membrane.stiffness
                           : world.contacts     ? world.contacts->parameters.stiffness
                                                : 1;
  return std::max(std::abs(bodies.pressure[slot]), minStrain * stiffness / radius);
}

}  // namespace

double residualOf(const World& world, std::span<const double> squares) {
  const Bodies& bodies = *world.bodies;
  double left = 0, pressure = 0, vertices = 0;
  for (int slot : bodies.slots) {
    const double radius = cubeRoot(3 * bodies.volume[slot] / (4 * std::numbers::pi));
    const double count = bodies.vertexCount(slot);
    const double traction = bodies.vertexMass[slot] * count / (4 * std::numbers::pi * radius * radius);
    left += traction * traction * squares[slot];
    vertices += count;
    pressure += scale(world, slot, radius);
  }
  return std::sqrt(left / vertices) / (pressure / bodies.count);
}

double measureResidual(const World& world) {
  const Bodies& bodies = *world.bodies;
  std::vector<double> squares(bodies.vertexMass.size(), 0);
  for (int slot : bodies.slots)
    for (int v = 0; v < bodies.vertexCount(slot); ++v) {
      const Vector a = bodies.read(bodies.acceleration, slot, v);
      squares[slot] += dot(a, a);
    }
  return residualOf(world, squares);
}

}  // namespace morula

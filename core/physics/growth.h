#pragma once
// Growth and shrinkage: a cell takes up or loses fluid and membrane together, at a constant relative rate.
#include "physics/bodies.h"

namespace morula {

/// Takes one time step of growth (rate > 0) or shrinkage (< 0): k_p and mass by the factor 1 + rate·Δt, rest lengths at
/// a third of the rate, so that a sphere's volume follows k_p at constant tension. Velocities stay: momentum grows with
/// the mass.
void grow(Bodies& bodies, int slot, double rate, double timeStep);

/// Returns a cell's volume at rest over the egg's [1]: k_p over the egg's with fluid under pressure, otherwise the cube
/// of its rest scale.
double sizeAtRest(const Bodies& bodies, int slot);

/// Grows a cell as `grow` does with a rate > 0, but not beyond this size (sizeAtRest): the last step covers what is
/// missing. A cell that is as large or larger does not change.
void growUntil(Bodies& bodies, int slot, double rate, double timeStep, double size);

}  // namespace morula

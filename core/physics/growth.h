#pragma once
// Growth and shrinkage: a cell takes up or loses fluid and membrane together, at a constant relative rate.
#include "physics/bodies.h"

namespace morula {

/// One time step of growth (rate > 0) or shrinkage (< 0): k_p and mass by the factor 1 + rate·Δt, rest
/// lengths by the third of it, so that a sphere's volume follows k_p at constant tension. Velocities stay:
/// momentum grows with the mass.
void grow(Bodies& bodies, int slot, double rate, double timeStep);

}  // namespace morula

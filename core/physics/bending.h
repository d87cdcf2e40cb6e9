#pragma once
// Bending of one cell's membrane in doubles, for measures; kernels have code of their own (bending_kernel.h).
#include "physics/bodies.h"

namespace morula {

/// Returns the energy of bending [force·length] of the cell in a slot; 0 without bending.
double measureBendingEnergy(const Bodies& bodies, int slot);

/// Returns the force of bending on each vertex [force] of the cell in a slot; zeros without bending.
std::vector<Vector> measureBendingForces(const Bodies& bodies, int slot);

}  // namespace morula

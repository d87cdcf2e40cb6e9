#pragma once
// How life begins: bodies, their lists and forces, and the kernels that compute them.
#include "state/world.h"

namespace morula {

/// Sets the world's kernels to those of an instruction set. Requires bodies.
void setStages(World& world, Isa isa);

/// Starts life with a new set of bodies: makes lists, forces and the time step for them.
void beginWithBodies(World& world);

}  // namespace morula

#pragma once
// Quasi-static growth: after each round of events the world relaxes to mechanical equilibrium, and time goes to the
// next event. A step is one event and the settling after it; the first step settles the scene's start. Masses, drag,
// damping and viscosity do not change where forces vanish, and have no effect.
//
// The way down is FIRE, cell by cell (physics/relax_kernel.h). It ends when
//
//   r = √(mean over vertices of (|F|/s)²) / mean over cells of p̂ ≤ tolerance  s: a vertex' share of its cell's surface
//   p̂ = max(|p|, 0.1 k_s/R)                                                   balls: 0.1 K/R
//
// the root mean square of tractions that are left, over the pressure in cells: the same on any mesh. A cell of radius R
// has the second p̂ where its membrane is stretched by less than 3 %, where its pressure vanishes.
#include "state/world.h"

namespace morula {

/// True if the scene's bodies settle instead of going through time steps.
bool settles(const World& world);

/// Takes one step of such a world, with up to `SettleParameters::evaluations` of the forces: time goes to the next
/// event, or where cells grow until one has grown by maxGrowth; then all settles. Throws NumericalError as step does.
void stepQuasiStatic(World& world);

/// [1] Max growth of mass and k_p between two settlings.
constexpr double maxGrowth = 0.02;

}  // namespace morula

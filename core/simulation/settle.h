#pragma once
// Quasi-static growth: after each round of events the world settles, and time goes to the next event. A step is one
// event and the settling after it; the first step settles the scene's start. Masses, drag, damping and viscosity do not
// change where forces vanish, and have no effect.
//
// Settling is a damped motion (damped_motion.h), of a number of evaluations in proportion to the time until the next
// cell cycle. Velocities go on from one settling to the next.
#include "state/world.h"

namespace morula {

/// True if the scene's bodies settle instead of going through time steps.
bool settles(const World& world);

/// Takes one step of such a world: time goes to the next event, or where cells grow until one has grown by maxGrowth;
/// then all settles. Throws NumericalError as step does.
void stepQuasiStatic(World& world);

/// Settles a world whose run is finished to QuasiStaticParameters::residual, if the scene gives one.
void settleEnd(World& world);

/// Returns the number of evaluations of the forces per time, for cells with so many vertices at most.
double evaluationsPerTime(const Scene& scene, int vertices);

/// [1] Max growth of mass and k_p between two settlings.
constexpr double maxGrowth = 0.02;

}  // namespace morula

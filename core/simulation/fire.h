#pragma once
// Integrator::fire: after each event the world relaxes by FIRE, cell by cell (physics/fire_kernel.h), until r [rest.h] is
// at most SettleParameters::tolerance. Gives way to damped motion (damped_motion.h).
#include "state/world.h"

namespace morula {

/// Settles with up to `SettleParameters::evaluations` of the forces. Throws NumericalError as step does.
void settleByFire(World& world);

}  // namespace morula

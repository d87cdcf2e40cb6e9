#pragma once
// Experiments in a running world: when the next one is due, and doing it.
#include "state/world.h"

namespace morula {

/// [time] When the next experiment is due that no event makes due: infinite without one. Cells that were born since
/// the last step count.
double nextExperiment(const World& world);

/// Does what is due at this time [time], in the order of the list. Throws NumericalError if no cell that an experiment
/// is for lives then.
void doExperiments(World& world, double time);

/// Brings genes and parameters to what the world's records say that was done. For a state that was restored.
void restoreExperiments(World& world);

}  // namespace morula

#pragma once
// From the eras that a trial run came to, to those that it did not.
#include "parts/trial_run.h"
#include "simulation/memory.h"

namespace morula {

/// [time] Up to which a time step will be stable after so many divisions: for equal parts of a free egg, times what the
/// trial run has found real cells to lose against them with each division, being uneven and pressed.
double predictTimeStepLimit(const TrialRun& trial, int generation);

/// [vertices] Of a cell, in the mean over those that live: cells may have different meshes. Of the egg if none lives.
double verticesPerCell(const Bodies& bodies);

/// One for each era of a life with bodies.
std::vector<EraCounts> extrapolate(const Life& life, const TrialRun& trial);

/// At the largest number of cells. Exact for a trial run that came to its end with them.
MemoryUse extrapolateMemory(const Life& life, const TrialRun& trial);

}  // namespace morula

#pragma once
// From the eras that were rehearsed to those that were not.
#include <vector>

#include "parts/rehearsal.h"
#include "simulation/memory.h"

namespace morula {

/// What an era will have counted in the end.
struct Outlook {
  double steps = 0, searches = 0, pairs = 0;
};

/// [time] Up to which a time step will be stable after so many divisions: for equal parts of a free egg,
/// times what the rehearsal has found real cells to lose against them with each division, being uneven and
/// pressed.
double foretellTimeStepLimit(const Rehearsal& rehearsal, int generation);

/// [vertices] Of a cell, in the mean over those that live: cells may have different meshes. Of the egg if
/// none lives.
double verticesPerCell(const Bodies& bodies);

/// One for each era of a life with bodies.
std::vector<Outlook> lookAhead(const Life& life, const Rehearsal& rehearsal);

/// When so many live. Exact for a rehearsal that came to its end with them.
MemoryUse foretellMemory(const Life& life, const Rehearsal& rehearsal);

}  // namespace morula

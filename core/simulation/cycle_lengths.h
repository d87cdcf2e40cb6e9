#pragma once
// The shortest and the longest cell cycle that a scene may bring.
#include <string>

#include "state/scene.h"

namespace morula {

struct ShortestCycle {
  double length;    // [time]
  std::string key;  // the key that gives it
};

/// Returns the shortest of a scene's cycles, without what a seed varies.
ShortestCycle shortestCycle(const CycleParameters& cycle);
/// Returns the shortest cycle of all cells that the scene may bring, whatever its seed.
ShortestCycle shortestCycle(const Scene& scene);

/// [time] The longest cycle that a cell of a scene may have, without what the seed varies.
double longestCycle(const CycleParameters& cycle);

/// Throws InputError if more cell cycles would come one after the other than any run can make, or if one
/// cycle is so much shorter than another that times cannot tell its beginning from its end.
void refuseEndlessPace(const Scene& scene);

}  // namespace morula

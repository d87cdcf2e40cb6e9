#pragma once
// The only place where goldens meet the simulation.
#include "golden/facts.h"

namespace morula {

struct World;

/// Returns the golden data of a finished world. `facts` already hold what the world does not tell. These are the
/// scenario's name (goldenName) and hash, and what was taken on the way: samples, links, pictures.
GoldenData observeGolden(const World& world, GoldenFacts facts);

}  // namespace morula

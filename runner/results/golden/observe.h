#pragma once
// Golden data from a world. No other file of goldens reads a World.
#include "golden/facts.h"

namespace morula {

struct World;

/// Returns the golden data of a finished world. `facts` already hold what the world lacks: the scenario's name
/// (goldenName) and hash, and samples, links and pictures.
GoldenData observeGolden(const World& world, GoldenFacts facts);

}  // namespace morula

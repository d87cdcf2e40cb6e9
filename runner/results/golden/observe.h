#pragma once
// The only place where goldens meet the simulation.
#include "golden/facts.h"

namespace morula {

struct World;

/// What a finished world's golden records: read off the world but for what `facts` hold already, which it does not
/// tell. These are the scenario's name (goldenName) and hash, and what was taken on the way: samples, links, pictures.
GoldenData observeGolden(const World& world, GoldenFacts facts);

}  // namespace morula

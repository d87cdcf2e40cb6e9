#pragma once
// Which cells stick to others alike.
#include "state/world.h"

namespace morula {

/// Tells contacts which cells stick to others alike, by their substances, and what the seed varies. Returns at once
/// where adhesion depends on neither.
void sortByAdhesion(World& world);

}  // namespace morula

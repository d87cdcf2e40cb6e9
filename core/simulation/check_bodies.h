#pragma once
// Ends a run whose bodies have become impossible.
#include "state/world.h"

namespace morula {

/// Throws NumericalError if a cell's volume is not a positive number below the largest sensible one.
void checkBodies(const World& world);

/// Throws BodyFailure if a cell begins deeper in another one than contacts reach: no force would part the two. Cost:
/// for each pair of cells whose bounding boxes overlap that deep, the vertices of one times the faces of the other.
void checkStart(const World& world);

/// Throws NumericalError if a vertex has moved farther in this step than its contacts reach: cells could then pass
/// through each other and never have touched. Must be called with all snapshots, before the list follows.
void checkReach(const World& world);

}  // namespace morula

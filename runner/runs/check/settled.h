#pragma once
// Whether a quasi-static run came as near to equilibrium as its scenario asks.
#include <string>
#include <vector>

#include "physics/parameters.h"
#include "simulation/world.h"

namespace morula {

/// A sentence on settlings that ended at `evaluations` above the tolerance: how many, the farthest, and what to change; "" where
/// there are none.
std::string unsettledText(const SettleParameters& asked, const std::vector<SettlingRecord>& settlings);

/// A sentence on how far from rest the settlings end that were measured (physics.settle.sample); "" where none was.
std::string distanceText(const std::vector<SettlingRecord>& settlings);

}  // namespace morula

#pragma once
// Divisions across the longest extent of cells that have none: another mesh or time step may cut them elsewhere.
#include <functional>
#include <string>
#include <vector>

#include "biology/lineage.h"
#include "division/record.h"
#include "simulation/scene.h"

namespace morula {

/// Those of `divisions` where the longest extent decides, and hardly differs from the next one. `describe` gives the
/// substances of a state in `lineage`.
std::vector<DivisionRecord> ambiguousDivisions(const Scene& scene, const std::vector<LineageEntry>& lineage,
                                               const std::function<std::string(StateId)>& describe,
                                               const std::vector<DivisionRecord>& divisions);

}  // namespace morula

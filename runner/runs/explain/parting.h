#pragma once
// Where a scenario that has changed leaves the path of the one before.
#include <string>

#include "scenario/scenario.h"

namespace morula {

/// Runs both side by side, on the same conditions, as long as they have the same cells at the same times. Lines for people, as
/// those of changeInWords: after which step a vertex first lies elsewhere, whose, and by how much [radii of the egg]; and from
/// which steps on the farthest vertex is 0.001, 0.01 and 0.1 radii away. "" without bodies, or if none ever is. Throws
/// Interrupted if a signal has come.
std::string partingInWords(const Scenario& before, const Scenario& now, const Execution& how);

}  // namespace morula

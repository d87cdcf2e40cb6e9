#pragma once
// The error of a quasi-static scene: how far from rest each of its settlings ends.
#include "document/table.h"
#include "scenario/scenario.h"

namespace morula {

/// Runs the scene to its end, and from each settling once more until the residual is a hundredth of the tolerance
/// (SettlingRecord). Throws InputError for a scene that cannot run to its end.
Table measureSettlings(Scenario scenario, const Execution& how);

}  // namespace morula

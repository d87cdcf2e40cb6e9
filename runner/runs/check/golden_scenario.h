#pragma once
// The scenario that a golden was accepted of, where the one of now is another.
#include <optional>

#include "golden/golden.h"
#include "scenario/scenario.h"

namespace morula {

/// A scenario with the values of the golden's lines `parameter`. From `now`, with these values in place of its own; or,
/// where they are not recorded in full (DNA, meshes and long texts are recorded as a hash), from the files as they were
/// when the golden was committed, or last of all. `now` itself if it has these values. Nothing where none of them has.
std::optional<Scenario> goldenScenario(const Scenario& now, const Golden& golden);

}  // namespace morula

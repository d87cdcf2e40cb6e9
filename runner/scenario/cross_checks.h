#pragma once
// Checks across parameters.
#include "scenario/parameter.h"

namespace morula::scenario {

/// Substances that the DNA does not know, an egg that does not fit its shell, pictures without bodies.
void crossCheck(const Scenario& scenario, Reading& reading, const Node& root);

}  // namespace morula::scenario

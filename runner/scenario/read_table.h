#pragma once
// Walks a document along the table of parameters.
#include "scenario/parameter.h"

namespace morula::scenario {

/// Fills the scenario from the document. Everything the table does not allow becomes a problem.
void readTable(const Node& root, Scenario& scenario, Reading& reading);

}  // namespace morula::scenario

#pragma once
// The parts of a scene that Bullet cannot compute, or that cannot be compared with it.
#include <string>
#include <vector>

#include "values/scenario_data.h"

namespace morula::scenario {

struct Incompatibility {
  bool lacks = false;  // Bullet has no such thing; otherwise the two would just not be comparable
  std::string wrong, right;
};

/// All reasons, or none. The scenario has mechanics.
std::vector<Incompatibility> bulletIncompatibilities(const Scenario& scenario, Baseline baseline);

}  // namespace morula::scenario

#pragma once
// The parts of a scene that Bullet cannot compute, or that cannot be compared with it.
#include <string>
#include <vector>

#include "values/scenario_data.h"

namespace morula::scenario {

struct Incompatibility {
  bool lacks = false;  // true: Bullet cannot compute this; false: the results would not be comparable
  std::string wrong, right;
};

/// Returns every reason for which a comparison with Bullet is impossible. The scenario must have mechanics.
std::vector<Incompatibility> bulletIncompatibilities(const Scenario& scenario, Baseline baseline);

}  // namespace morula::scenario

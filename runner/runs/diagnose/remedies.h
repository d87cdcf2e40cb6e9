#pragma once
// Remedies that might keep a run from failing: one change of one key each.
#include <functional>
#include <string>
#include <vector>

#include "simulation/simulation.h"

namespace morula {

struct Remedy {
  std::string key;                    // "physics.time_step"
  std::string value;                  // the value for the key
  std::function<void(World&)> apply;  // changes a world in the middle of its run
};

/// Returns the changes that make sense for the scene, the mildest first. `timeStep`, unless 0, comes before all others.
std::vector<Remedy> remediesFor(const World& world, double timeStep);

}  // namespace morula

#pragma once
// Remedies that might keep a run from failing: one change of one key each.
#include <functional>
#include <string>
#include <vector>

#include "simulation/world.h"

namespace morula {

struct Remedy {
  std::string key;                    // "physics.time_step"
  std::string value;                  // what would stand there
  std::function<void(World&)> apply;  // to a world in the middle of its run
};

/// The changes that make sense for the scene, the mildest first; `timeStep`, unless 0, before all others.
std::vector<Remedy> remediesFor(const World& world, double timeStep);

}  // namespace morula

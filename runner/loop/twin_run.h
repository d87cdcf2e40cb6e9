#pragma once
// How fast two runs part that differ in one last place: the measure of chaos in a scene.
#include <functional>
#include <vector>

#include "base/hash.h"
#include "golden/golden.h"

namespace morula {

struct World;

struct TwinRun {
  std::vector<GoldenGrowth> growth;  // decades from 1e-15 up, as far as they are reached
  Hash end;                          // of the undisturbed world's last state
};

/// Moves x of the twin's first vertex by one unit in the last place and runs both to the end. Their distance
/// is the largest difference of any coordinate, in radii of the egg; infinite from where other cells live, or
/// where only one goes on. Both are worlds of one scene with bodies at step 0. `watch` is called before every
/// step.
TwinRun runTwins(World world, World twin, const std::function<void(const World&)>& watch = {});

}  // namespace morula

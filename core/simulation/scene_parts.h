#pragma once
// Hashes of a scene, one for each part, so that the parts in which two scenes differ can be named.
#include <string>
#include <vector>

#include "base/hash.h"

namespace morula {

struct Scene;

struct ScenePart {
  std::string name;  // as a scenario calls it: dna, physics, …
  std::string hash;  // of an absent part: ""
};

/// All that decides how a state goes on, in one order. Neither the scene's name nor when it stops: a state
/// may be gone on with for longer than was planned.
std::vector<ScenePart> hashSceneParts(const Scene& scene);

}  // namespace morula

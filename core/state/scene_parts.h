#pragma once
// Hashes of a scene, one for each part, so that the parts in which two scenes differ can be named.
#include <string>
#include <vector>

#include "base/hash.h"

namespace morula {

struct Scene;

struct ScenePart {
  std::string name;  // as a scenario calls it: dna, physics, …
  std::string hash;  // "" for an absent part
};

/// Returns the hashes of all parts that decide how a state goes on, in one order. The scene's name and its stop are not
/// among them: a state may go on for longer than was planned.
std::vector<ScenePart> hashSceneParts(const Scene& scene);

}  // namespace morula

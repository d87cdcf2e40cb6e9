#pragma once
// The only place where goldens meet the simulation.
#include <string>
#include <vector>

#include "golden/facts.h"

namespace morula {

struct World;

struct GoldenContext {
  std::string scenario;                // "thesis/unique-four", from goldenName
  std::string scenarioHash;            // semantic
  std::vector<WorldMeasures> samples;  // taken on the way, may be empty
  std::vector<ChainLink> chain;        // may be empty
  std::vector<GoldenImage> images;     // may be empty
};

/// Reads off a finished world what its golden records.
GoldenData observeGolden(const World& world, const GoldenContext& context);

}  // namespace morula

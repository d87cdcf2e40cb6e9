#pragma once
// Helpers of the accuracy tests: scenarios given as text, and options with few settings.
#include <string>

#include "accuracy/accuracy.h"

namespace morula {

inline ReadScenario reader(const std::string& text) {
  return [text](const std::vector<std::string>& changes) {
    std::vector<Override> overrides;
    for (const auto& change : changes) overrides.push_back(parseOverride(change));
    return readScenario(text, "test.yaml", ".", overrides);
  };
}

/// Returns options that try the scene's own integrator, precision and law in two time steps, each once.
inline AccuracyOptions fewSettings() {
  return {.otherPrecision = false, .otherLaw = false, .halvings = 1, .rounds = 1};
}

}  // namespace morula

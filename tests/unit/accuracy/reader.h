#pragma once
#include <string>

#include "accuracy/trial.h"

namespace morula {

/// Of a scenario given as text.
inline ReadScenario reader(const std::string& text) {
  return [text](const std::vector<std::string>& changes) {
    std::vector<Override> overrides;
    for (const auto& change : changes) overrides.push_back(parseOverride(change));
    return readScenario(text, "test.yaml", ".", overrides);
  };
}

}  // namespace morula

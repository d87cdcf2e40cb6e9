#include "reader/scenario.h"

#include "base/floating_point.h"
#include "library/scene_format.h"
#include "reader/source.h"

namespace morula {

std::vector<Override> overridesOf(const std::vector<std::string>& sets, std::optional<std::uint64_t> seed) {
  std::vector<Override> overrides;
  for (const std::string& set : sets) overrides.push_back(parseOverride(set));
  if (seed) overrides.push_back({"seed", std::to_string(*seed), "--seed"});
  return overrides;
}

Scenario readSource(const std::string& source, const std::vector<Override>& overrides) {
  if (source.find('\n') == source.npos) return loadScenario(source, overrides);
  return readScenario(source, "scenario", ".", overrides);
}

ReadScenario readScenario(const std::string& source, const std::vector<std::string>& sets,
                          std::optional<std::uint64_t> seed) {
  const FloatingPointMode mode;
  Scenario scenario = readSource(source, overridesOf(sets, seed));
  return {writeScene(std::move(scenario.scene)), std::move(scenario.warnings)};
}

}  // namespace morula

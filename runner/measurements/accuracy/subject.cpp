#include "accuracy/subject.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/number_text.h"
#include "loop/simulate.h"
#include "system/usage_error.h"

namespace morula {

ReadScenario variantsOf(std::string file, std::vector<Override> overrides, bool allowOutside) {
  return [=](const std::vector<std::string>& changes) {
    auto all = overrides;
    for (const auto& change : changes) {
      const auto path = change.substr(0, change.find('='));
      std::erase_if(all, [&](const Override& o) { return o.path == path; });
      all.push_back(parseOverride(change));
    }
    if (!changes.empty()) {
      all.push_back(parseOverride("check={}"));
      all.push_back(parseOverride("record.measures=null"));
    }
    return loadScenario(file, all, allowOutside);
  };
}

double timeReached(World world, std::uint64_t steps, double latest) {
  for (; steps > 0 && world.clock.time < latest && !finished(world); --steps) step(world);
  return world.clock.time;
}

void requireWithinScene(World world, double until) {
  double reached = until;
  try {
    const double end = plannedEnd(world.model).value_or(0);
    reached = end > 0 ? end : timeReached(std::move(world), UINT64_MAX, until);
  } catch (const NumericalError&) { return; }
  if (reached < until * (1 - 1e-9))
    throw UsageError(
        fmt::format("--until: {} is after the scene's end; needs at most {}", exactText(until), numberText(reached)));
}

Json originOf(const Scenario& scenario, const Execution& execution, const std::string& command) {
  const RunRecord record = recordOf(scenario, execution, command);
  Json json = Json::object();
  eachFieldOf({.record = record}, [&](const RunField& field, const std::string& value) {
    if (field.part != RunPart::result && !value.empty()) json[headingOf(field)] = value;
  });
  return json;
}

}  // namespace morula

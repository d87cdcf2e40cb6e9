#include "loop/scenario_run.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "physics/integrator.h"
#include "store/build_info.h"
#include "system/usable_memory.h"

namespace morula {

World makeScenarioWorld(const Scenario& scenario, const Execution& execution) {
  try {
    Execution limited = execution;
    if (std::isinf(limited.memoryLimit)) limited.memoryLimit = usableMemory();
    return makeWorld(scenario.scene, limited);
  } catch (const InputError& error) {
    // The simulator knows keys, but not their files and lines.
    std::string what = error.what();
    const auto place = scenario.places.find(error.key);
    if (place == scenario.places.end()) throw InputError(scenario.file + ": " + what, error.want, error.key);
    // "cell A: physics.time_step 0.02 is above …"; a place that --set gave ends with the key.
    if (const auto at = what.find(error.key); at != what.npos)
      what.erase(at, what.find_first_not_of(": ", at + error.key.size()) - at);
    throw InputError(place->second + (place->second.ends_with(error.key) ? ": " : ": " + error.key + ": ") + what,
                     error.want, error.key);
  }
}

Execution otherExecution(const Execution& how) {
  Execution other = how;
  other.threads = how.threads == 1 ? 2 : 1;
  const auto isas = availableIsas();
  const auto place = std::find(isas.begin(), isas.end(), how.isa);
  if (isas.size() > 1) other.isa = place == isas.begin() ? isas[1] : *(place - 1);
  return other;
}

std::uint64_t stepsPerHashOf(const Scene& scene) {
  return scene.mechanics && !kindOf(scene.mechanics->physics.integrator).settles ? stepsPerHash : 1;
}

bool wantsHashes(const Scenario& scenario, bool hasGolden) { return hasGolden || scenario.places.contains("check"); }

RunRecord recordOf(const Scenario& scenario, const Execution& execution, const std::string& command) {
  RunRecord record;
  record.scenario = scenario.scene.name;
  record.scenarioHash = scenario.meaning.text();
  if (scenario.referenceMeaning) record.referenceHash = scenario.referenceMeaning->text();
  record.seed = scenario.scene.seed;
  record.documents = {{"scenario", scenario.file, scenario.bytes}, {"resolved", "", scenario.resolved}};
  for (const auto& file : scenario.files) record.documents.push_back({file.role, file.path, file.content});
  if (!buildDiff().empty()) record.documents.push_back({"diff", "", buildDiff()});
  record.command = command;
  record.isa = name(execution.isa);
  record.threads = execution.threads;
  return record;
}

RecordOptions recordingOf(const Scenario& scenario, bool hashes) {
  RecordOptions record{.every = scenario.record.every,
                       .atCells = scenario.record.atCells,
                       .measures = scenario.record.measures,
                       .reference = scenario.check.reference,
                       .nameOf = scenario.names.function(),
                       .meshes = scenario.record.meshes};
  if (hashes) record.hashEvery = stepsPerHashOf(scenario.scene);
  return record;
}

}  // namespace morula

// morula validate: checks scenarios and studies without running them.

#include "base/error.h"
#include "cli/verbs.h"
#include "files/text.h"
#include "files/write_file.h"
#include "library/scene_format.h"
#include "loop/simulate.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study/plan.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct ValidateOptions {
  std::vector<std::string> scenarios;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
  bool resolved = false;
  std::string sceneFile;
};

/// Checks a study with all its conditions.
Json validateStudy(const std::string& file, const ValidateOptions& options, const Execution& how) {
  if (!options.scene.empty()) throw UsageError("--set and --seed are for scenarios, and '" + file + "' is a study");
  if (!options.sceneFile.empty())
    throw UsageError("--scene writes the scene of a scenario, and '" + file + "' is a study");
  const Plan plan = makePlan(loadStudy(file, options.input.allowOutside), {.predict = false, .execution = how});
  tellWarnings(plan.warnings, options.output.quiet);
  Json summary = summaryOf(plan);
  if (options.resolved && !options.output.json) print(jsonText(summary, 2) + "\n");
  else if (!options.output.json)
    print(file + ": fine; conditions: " + std::to_string(plan.conditions.size()) +
          ", distinct runs: " + std::to_string(plan.tasks.size()) + "\n");
  Json entry{{"file", file},    {"valid", true},           {"study", plan.study.name},
             {"plan", plan.id}, {"errors", Json::array()}, {"warnings", plan.warnings}};
  if (options.resolved) entry["resolved"] = std::move(summary);
  return entry;
}

int act(const ValidateOptions& options) {
  if (!options.sceneFile.empty() && options.scenarios.size() != 1)
    throw UsageError("--scene: writes the scene of one scenario, and " + std::to_string(options.scenarios.size()) +
                     " are given");
  const Execution how = execution(options.execution);
  int code = fine;
  Json list = Json::array();
  for (const auto& file : options.scenarios) {
    try {
      if (isStudy(file)) {
        list.push_back(validateStudy(file, options, how));
        continue;
      }
      const auto scenario = loadScenario(file, overrides(options.scene), options.input.allowOutside);
      makeScenarioWorld(scenario, how);  // throws for a time step above the stability limit
      list.push_back({{"file", file},
                      {"valid", true},
                      {"scenario", scenario.scene.name},
                      {"scenario_hash", scenario.meaning.text()},
                      {"errors", Json::array()},
                      {"warnings", scenario.warnings}});
      tellWarnings(scenario.warnings, options.output.quiet);
      if (!options.sceneFile.empty()) writeFile(options.sceneFile, writeScene(scenario.scene), Content::scene);
      if (options.resolved && options.output.json) list.back()["resolved"] = parseJson(scenario.resolved);
      else if (options.resolved) print(scenario.resolved);
      else if (!options.output.json)
        print(file + ": fine; " + std::to_string(scenario.scene.dna.genes.size()) + " genes" +
              (scenario.scene.mechanics ? "" : ", lineage only") + "\n");
    } catch (const InputError& error) {
      code = input;
      tellInputError(error.what());
      list.push_back(
          {{"file", file}, {"valid", false}, {"errors", linesOf(error.what())}, {"warnings", Json::array()}});
    }
  }
  if (options.output.json) printJson({{"scenarios", list}});
  return code;
}

}  // namespace

void addValidate(CLI::App& app, Action& action) {
  Verb verb(app, action, "validate", "List all mistakes in scenario and study files");
  auto& options = verb.does<ValidateOptions>(act);
  verb.needs("scenario", options.scenarios, "FILE", "Scenario or study files");
  add(verb, options.input);
  add(verb, options.scene);
  addMemoryLimit(verb, options.execution);
  verb.takes("--resolved", options.resolved, "Print every parameter, defaults and changes included, as JSON");
  verb.takes("--scene", options.sceneFile, "FILE",
             "Write the scene in the text format of the library (morula.h) and of pages that run again");
  add(verb, options.output);
}

}  // namespace morula::cli

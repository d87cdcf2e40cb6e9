#include "cli/stated_errors.h"

#include "accuracy/into_golden.h"
#include "accuracy/subject.h"
#include "base/error.h"
#include "loop/scenario_run.h"
#include "options/exit_codes.h"
#include "options/program.h"
#include "system/console.h"

namespace morula::cli {
namespace {

/// Measures one scenario and prints its report.
void stateErrorOf(const StatedErrorsCommand& command, const std::string& file) {
  const ReadScenario read = variantsOf(file, {}, command.input.allowOutside);
  const Scenario scenario = read({});
  refuseIntoGolden(scenario);
  AccuracyOptions options{.until = command.until, .budget = command.budget, .execution = execution(command.execution)};
  options.tell = [quiet = command.output.quiet](const std::string& text) { tell("review: " + text, quiet); };
  World start = makeScenarioWorld(scenario, options.execution);  // mistakes are reported with their places
  if (command.until) requireWithinScene(std::move(start), *command.until);
  const AccuracyReport report = stateInGolden(read, options);
  if (!command.output.json) return print(textOf(describe(report)));
  Json json = toJson(report, "");
  json["file"] = file, json["made_by"] = originOf(scenario, options.execution, commandLine());
  printJson(json);
}

}  // namespace

int stateErrors(const StatedErrorsCommand& command) {
  const auto& files = command.files;
  if (files.empty()) throw UsageError("--into-golden: name the scenarios that are meant");
  if (files.size() == 1) return stateErrorOf(command, files.front()), fine;
  if (command.output.json)
    throw UsageError("--into-golden: with --json review takes one scenario, not " + std::to_string(files.size()));
  int code = fine;
  for (const std::string& file : files) {
    try {
      const Scenario scenario = loadScenario(file, {}, command.input.allowOutside);
      if (!scenario.scene.mechanics || !scenario.check.fails.empty()) {
        tell("review: " + file + ": left out: " + (scenario.scene.mechanics ? "it must fail" : "it has no bodies"),
             command.output.quiet);
        continue;
      }
      stateErrorOf(command, file);
    } catch (const InputError& error) {
      tellInputError(error.what());
      code = input;
    }
  }
  return code;
}

int printStatedErrors(const StatedErrorsCommand& command) {
  if (command.files.empty()) throw UsageError("--stated: name the golden files, as golden/*/*.golden");
  std::vector<Golden> goldens;
  for (const std::string& file : command.files) goldens.push_back(readGoldenFile(file));
  std::erase_if(goldens, [](const Golden& g) { return !hasBodies(g); });
  print(statedErrorsAsMarkdown(goldens));
  return fine;
}

}  // namespace morula::cli

// morula review: what golden files would change, and with a reason the change itself.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>

#include "base/error.h"
#include "cli/check_run.h"
#include "cli/console.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/pictures.h"
#include "cli/verbs.h"
#include "golden/accept.h"

namespace morula::cli {

namespace {

struct ReviewOptions {
  std::vector<std::string> scenarios;
  ExecutionOptions execution;
  OutputOptions output;
  bool accept = false;
  std::string why, by;
};

/// Bits are checked exactly; the values beside them tell how large a difference is.
std::vector<ToleranceRule> usualRules(const Scenario& scenario) {
  if (!scenario.scene.mechanics) return {};  // a lineage has no values
  return {
      readRule("tolerance * rel 1e-9 scale 1 why \"what the bits tell exactly, in numbers people can weigh\"",
               "usual rules")};
}

int act(const ReviewOptions& options) {
  const auto how = execution(options.execution);
  if (options.accept && options.why.empty())
    throw UsageError(
        "morula review --accept needs a reason: --why \"what changed and why the new result is right\"");
  if (options.accept && options.by.empty())
    throw UsageError("morula review --accept needs a name: --by NAME");
  std::vector<Scenario> scenarios;
  for (const auto& file : options.scenarios) scenarios.push_back(loadScenario(file));

  int code = fine;
  Json accepted = Json::array();
  for (const auto& scenario : scenarios) {
    Progress progress(scenario.scene.name, options.output.quiet);
    const auto run = simulate(makeScenarioWorld(scenario, how), recordingOf(scenario, true), progress);
    if (run.signal) return signalled + run.signal;
    if (run.end.status != RunStatus::done) throw InputError(scenario.file + ": " + run.end.failure);
    const auto report = check(scenario, run, true);
    if (!options.output.json) print(describe(report));
    if (!options.accept) {
      if (!report.passed()) code = differs;
      continue;
    }
    const auto file = goldenFile(scenario);
    const auto rules = std::filesystem::exists(file) ? readGoldenFile(file).rules : usualRules(scenario);
    makeFolder(file.parent_path());
    acceptGolden(file, observe(scenario, run), rules, {options.by, options.why});
    accepted.push_back(file.string());
    if (!options.output.json) print("accepted: " + file.string() + "\n");
  }
  if (options.output.json) printJson({{"accepted", accepted}});
  return code;
}

}  // namespace

void addReview(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReviewOptions>();
  if (const char* user = std::getenv("USER")) options->by = user;
  auto* verb =
      app.add_subcommand("review", "Show what golden files would change, or accept the change with a reason");
  verb->add_option("scenario", options->scenarios, "Scenario files")->required()->type_name("FILE");
  verb->add_flag("--accept", options->accept, "Write the golden files");
  verb->add_option("--why", options->why, "What changed and why the new result is right")->type_name("TEXT");
  verb->add_option("--by", options->by, "Who accepts; default: the user's name")->type_name("NAME");
  add(*verb, options->execution);
  add(*verb, options->output);
  verb->callback([options, &action] { action = [options] { return act(*options); }; });
}

}  // namespace morula::cli

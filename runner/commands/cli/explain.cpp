// morula explain: where and why a result differs.
#include <memory>

#include "cli/verbs.h"
#include "explain/why.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "system/console.h"
#include "system/signals.h"

namespace morula::cli {

namespace {

struct ExplainOptions {
  std::string scenario;
  std::string with, database, run, every = "64";
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

int act(const ExplainOptions& options) {
  if (!options.with.empty() && !options.database.empty())
    throw UsageError("morula explain: --with or --db, not both");
  if (!options.run.empty() && options.database.empty())
    throw UsageError("morula explain: --run chooses a run of --db FILE");
  const auto how = execution(options.execution);
  const Scenario scenario = loadScenario(options.scenario, {}, options.input.allowOutside);
  try {
    const Findings f = findWhy(scenario, {.program = options.with,
                                          .database = options.database,
                                          .run = options.run,
                                          .every = naturalOption("--every", options.every, 1, 1'000'000'000),
                                          .execution = how,
                                          .quiet = options.output.quiet});
    if (options.output.json) printJson(toJson(scenario, f));
    else print(f.text);
    return f.failureClass.empty() ? fine : differs;
  } catch (const Interrupted& by) { return signalled + by.signal; }
}

}  // namespace

void addExplain(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  Verb verb(app, action, "explain",
            "Say where and why a result differs: first step, cell, vertex, both values");
  verb.needs("scenario", options->scenario, "FILE", "Scenario file");
  verb.takes("--with", options->with, "PROGRAM",
             "Compare with what this Morula program gives, perhaps an older build");
  verb.takes("--db", options->database, "FILE", "Compare with a stored run");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--every", options->every, "STEPS",
             "Look at every so many steps first; 1 finds also what heals");
  add(verb, options->input);
  add(verb, options->execution);
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

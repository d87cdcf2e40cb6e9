// morula explain: where and why a result differs.

#include "cli/verbs.h"
#include "explain/why.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct ExplainOptions {
  std::string scenario;
  std::string with, database, run;
  std::uint64_t every = 64;
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

int act(const ExplainOptions& options) {
  const auto how = execution(options.execution);
  const Scenario scenario = loadScenario(options.scenario, {}, options.input.allowOutside);
  const Findings f = findWhy(scenario, {.program = options.with,
                                        .database = options.database,
                                        .run = options.run,
                                        .every = options.every,
                                        .execution = how,
                                        .quiet = options.output.quiet});
  printEither(options.output, toJson(scenario, f), f.text);
  return f.failureClass == FailureClass::none ? fine : differs;
}

}  // namespace

void addExplain(CLI::App& app, Action& action) {
  Verb verb(app, action, "explain", "Find where and why a result differs: first step, cell, vertex, both values");
  auto& options = verb.does<ExplainOptions>(act);
  verb.needs("scenario", options.scenario, "FILE", "Scenario file");
  verb.takes("--with", options.with, "PROGRAM",
             "Compare with the results of this Morula program, perhaps an older "
             "build");
  verb.takes("--db", options.database, "FILE", "Compare with a stored run");
  addRunChoice(verb, options.run);
  verb.oneOf({"--with", "--db"});
  verb.onlyWith({"--run"}, {"--db"});
  verb.takes("--every", options.every, "STEPS", natural(1, 1'000'000'000),
             "First compare states N steps apart; 1 also finds differences that vanish again");
  add(verb, options.input);
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli

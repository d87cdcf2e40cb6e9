// morula internal trail: the hashes of a run's states, for another Morula program that asks (explain --with).
#include <limits>

#include "base/error.h"
#include "cli/verbs.h"
#include "explain/explain.h"
#include "explain/run_source.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "state/checkpoint.h"
#include "system/console.h"

namespace morula::cli {
namespace {

constexpr std::uint64_t toTheEnd = std::numeric_limits<std::uint64_t>::max() / 2;

struct TrailOptions {
  std::string scenario;
  std::uint64_t from = 0, to = toTheEnd, every = 64;
  std::optional<std::uint64_t> state;
  InputOptions input;
  ExecutionOptions execution;
};

int act(const TrailOptions& options) {
  const Scenario scenario = loadScenario(options.scenario, {}, options.input.allowOutside);
  const auto how = execution(options.execution);
  OwnRun run = scenarioRun(scenario, how);
  if (options.state) {
    const HashTrace there = run.hashTrace(*options.state, *options.state, 1);
    if (!there.failure.empty())
      throw InputError("no state at step " + std::to_string(*options.state) + ": " + there.failure);
    printBytes(saveState(*run.stateAt(*options.state)));
    return fine;
  }
  if (options.to < options.from)
    throw UsageError("--to " + std::to_string(options.to) + " comes before --from " + std::to_string(options.from));
  print(writeHashTrace(run.hashTrace(options.from, options.to, options.every)));
  return fine;
}

}  // namespace

void addTrail(CLI::App& app, Action& action) {
  Verb verb(app, action, "trail", "Print hashes of a run's states, or one state, for another Morula");
  auto& options = verb.does<TrailOptions>(act);
  verb.needs("scenario", options.scenario, "FILE", "Scenario file");
  verb.takes("--from", options.from, "STEP", natural(0, toTheEnd), "The first step");
  verb.takes("--to", options.to, "STEP", natural(0, toTheEnd), "The last step");
  verb.takes("--every", options.every, "N", natural(1, toTheEnd), "Number of steps between hashes");
  verb.takes("--state", options.state, "STEP", natural(0, toTheEnd),
             "Print the whole state after this step as bytes instead");
  add(verb, options.input);
  add(verb, options.execution);
}

}  // namespace morula::cli

// morula trail: where a run goes, in hashes; one Morula asks another so (explain --with).
#include <limits>
#include <memory>

#include "base/error.h"
#include "cli/verbs.h"
#include "explain/explain.h"
#include "explain/hash_trace_json.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "simulation/checkpoint.h"
#include "system/console.h"

namespace morula::cli {

namespace {

constexpr std::uint64_t toTheEnd = std::numeric_limits<std::uint64_t>::max() / 2;

struct TrailOptions {
  std::string scenario;
  std::string from = "0", to = std::to_string(toTheEnd), every = "64", state;
  InputOptions input;
  ExecutionOptions execution;
};

int act(const TrailOptions& options) {
  const Scenario scenario = loadScenario(options.scenario, {}, options.input.allowOutside);
  const auto how = execution(options.execution);
  OwnRun run = scenarioRun(scenario, how);
  if (!options.state.empty()) {
    const auto step = naturalOption("--state", options.state, 0, toTheEnd);
    const HashTrace there = run.hashTrace(step, step, 1);
    if (!there.failure.empty()) throw InputError("no state at step " + options.state + ": " + there.failure);
    printBytes(saveState(*run.stateAt(step)));
    return fine;
  }
  const auto from = naturalOption("--from", options.from, 0, toTheEnd);
  const auto to = naturalOption("--to", options.to, 0, toTheEnd);
  if (to < from) throw UsageError("--to " + options.to + " comes before --from " + options.from);
  print(writeHashTrace(run.hashTrace(from, to, naturalOption("--every", options.every, 1, toTheEnd))));
  return fine;
}

}  // namespace

void addTrail(CLI::App& app, Action& action) {
  auto options = std::make_shared<TrailOptions>();
  Verb verb(app, action, "trail", "Print hashes of a run's states, or one state, for another Morula");
  verb.needs("scenario", options->scenario, "FILE", "Scenario file");
  verb.takes("--from", options->from, "STEP", "The first step");
  verb.takes("--to", options->to, "STEP", "The last step");
  verb.takes("--every", options->every, "N", "Every so many steps");
  verb.takes("--state", options->state, "STEP", "Instead, the whole state after this step, as bytes");
  add(verb, options->input);
  add(verb, options->execution);
  verb.hide();  // not for people
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

#include "loop/simulate.h"

#include "base/error.h"
#include "loop/run.h"
#include "loop/samples.h"
#include "system/signals.h"

namespace morula {

void KeptForGolden::add(const RunResults& more) {
  tables.addRecords(more);
  for (const Sample& s : more.samples) records.samples.push_back({s.world, {}, {}});
  records.chain.insert(records.chain.end(), more.chain.begin(), more.chain.end());
}

Simulation simulate(const Scenario& scenario, const Execution& how, RunOptions options) {
  return simulate(scenario, makeScenarioWorld(scenario, how), std::move(options));
}

Simulation simulate(const Scenario& scenario, World world, RunOptions options) {
  options.record.nameOf = scenario.names.function();
  Samples samples(options.record, options.sink);
  Run run(std::move(world), {.label = options.label.empty() ? scenario.scene.name : options.label,
                             .quiet = options.quiet,
                             .nameOf = options.record.nameOf,
                             .storesRecords = static_cast<bool>(options.sink)});
  run.watch(samples);
  for (Observer* observer : options.watch) run.watch(*observer);
  const RunEnd end = run.toEnd();
  if (end.status == RunStatus::killed) throw Interrupted{SignalWatch::caught()};
  RunResults results = samples.take(run.world(), end);
  return {run.takeWorld(), end, std::move(results)};
}

void requireEnough(const RunEnd& end) {
  if (end.want != Want::nothing) throw NumericalError(end.failure, end.want);
}

}  // namespace morula

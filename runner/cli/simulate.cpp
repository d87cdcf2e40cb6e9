#include "cli/simulate.h"

#include "base/error.h"
#include "cli/signals.h"

namespace morula::cli {

namespace {

/// State hashes on the way tell at which step two runs part. A hash costs about as much as a step.
constexpr std::uint64_t stepsPerHash = 64;

}  // namespace

World makeScenarioWorld(const Scenario& scenario, const Execution& execution) {
  try {
    return makeWorld(scenario.scene, execution);
  } catch (const InputError& error) { throw InputError(scenario.file + ": " + error.what()); }
}

Simulation simulate(const Scenario& scenario, World world, Progress& progress,
                    const std::function<void(const World&)>& watch) {
  Simulation run{std::move(world), {}, {}, 0};
  Recorder recorder({scenario.record.every, scenario.scene.mechanics ? stepsPerHash : 1});
  const auto observe = [&] {
    recorder.observe(run.world);
    if (watch) watch(run.world);
    progress.show(run.world);
  };

  const SignalWatch signals;
  auto status = RunStatus::done;
  std::string failure;
  try {
    observe();
    while (!finished(run.world)) {
      if ((run.signal = SignalWatch::caught()) != 0) {
        status = RunStatus::killed;
        break;
      }
      step(run.world);
      observe();
    }
  } catch (const NumericalError& error) {
    status = RunStatus::failed;
    failure = error.what();
  }
  progress.clear();
  run.end = endOf(run.world, status, failure);
  run.results = recorder.take(run.world, status == RunStatus::failed);
  return run;
}

}  // namespace morula::cli

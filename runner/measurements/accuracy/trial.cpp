#include "accuracy/trial.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number_text.h"
#include "loop/twin_run.h"
#include "system/clock.h"
#include "system/statistics.h"

namespace morula {
namespace {

constexpr double slack = 1e-9;  // of a time: sums of time steps may miss it by rounding

struct TooLong {
  std::string text;
};

/// Steps until the time is reached and adds up what that costs.
void goTo(World& world, double time, double mostSeconds, Trial& trial, double& seconds) {
  const std::uint64_t perStep = evaluationsPerStep(trial.setting);
  while (world.clock.time < time * (1 - slack) && !world.cells.path.empty()) {
    const auto vertices = static_cast<std::uint64_t>(world.bodies->livingVertices), before = world.clock.step;
    const std::uint64_t most = stepsUntil(world.clock, time * (1 - slack));
    seconds += timeOf(ClockKind::process, [&] { takeSteps(world, most); });
    const std::uint64_t steps = world.clock.step - before;
    if (seconds > mostSeconds) throw TooLong{"it takes more than " + numberText(mostSeconds, 3) + " s of CPU time"};
    trial.steps += steps;
    trial.forceEvaluations += steps * perStep;
    trial.vertexSteps += steps * vertices;
  }
}

void runOnce(const Scene& scene, const std::vector<double>& times, const Execution& execution, double mostSeconds,
             Trial& trial, double& seconds) {
  World world = makeWorld(scene, execution);
  trial.shapes.push_back(takeShapes(world));
  for (const double time : times) {
    goTo(world, time, mostSeconds, trial, seconds);
    trial.shapes.push_back(takeShapes(world));
    trial.born = world.lineage.entries;
    trial.divisions = world.divisions;
  }
}

}  // namespace

Trial runTrial(const ReadScenario& read, const Setting& setting, const std::vector<double>& times,
               const Execution& execution, int rounds, double mostSeconds) {
  std::vector<double> seconds;
  Trial trial;
  for (int round = 0; round < rounds && trial.failure.empty(); ++round) {
    trial = {};
    trial.setting = setting;
    double took = 0;
    try {
      runOnce(read(changesFor(setting)).scene, times, execution, mostSeconds, trial, took);
    } catch (const InputError& error) { trial.failure = error.what(); } catch (const NumericalError& error) {
      trial.failure = error.what();
    } catch (const TooLong& late) { trial.failure = late.text; }
    seconds.push_back(took);
  }
  trial.cpuSeconds = median(seconds);
  return trial;
}

Horizon findHorizon(const Scene& scene, const Execution& execution, std::optional<double> latest,
                    double amplification) {
  Twins twins(makeWorld(scene, execution), makeWorld(scene, execution));
  const World& world = twins.world();
  Horizon horizon{0, 0, false, world.clock.timeStep, world.clock.timeStep};
  while (!finished(world) && !(latest && world.clock.time >= *latest)) {
    const double apart = twins.step();
    horizon.parted = apart > amplification * twins.ulp();
    if (horizon.parted) break;
    horizon.rounding = std::max(horizon.rounding, apart);
    horizon.end = world.clock.time;
    horizon.leastTimeStep = std::min(horizon.leastTimeStep, world.clock.timeStep);
    horizon.mostTimeStep = std::max(horizon.mostTimeStep, world.clock.timeStep);
  }
  return horizon;
}

}  // namespace morula

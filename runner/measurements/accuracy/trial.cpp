#include "accuracy/trial.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "loop/twin_run.h"
#include "physics/cell_model.h"
#include "physics/integrator.h"
#include "system/clock.h"

namespace morula {
namespace {

struct TooLong {
  std::string text;
};

/// Returns the number of force evaluations in a step; XPBD's sub-steps count.
std::uint64_t evaluationsPerStep(const Setting& s) {
  return static_cast<std::uint64_t>(kindOf(s.integrator).evaluations) * s.substeps.value_or(1);
}

/// Steps until the time is reached, and adds up the cost.
void goTo(World& world, double time, double maxSeconds, Trial& trial, double& seconds) {
  const std::uint64_t perStep = evaluationsPerStep(trial.setting);
  while (world.clock.time < time * (1 - timeSlack) && !world.cells.path.empty()) {
    const auto vertices = static_cast<std::uint64_t>(world.bodies->livingVertices), before = world.clock.step;
    const std::uint64_t most = stepsUntil(world.clock, time * (1 - timeSlack));
    seconds += timeOf(ClockKind::process, [&] { takeSteps(world, most); });
    const std::uint64_t steps = world.clock.step - before;
    if (seconds > maxSeconds) throw TooLong{"the run takes more than " + numberText(maxSeconds, 3) + " s of CPU time"};
    trial.steps += steps;
    trial.forceEvaluations += steps * perStep;
    trial.vertexSteps += steps * vertices;
  }
}

void runOnce(const Scene& scene, const std::vector<double>& times, const Execution& execution, double maxSeconds,
             Trial& trial, double& seconds) {
  World world = makeWorld(scene, execution);
  trial.shapes.push_back(takeShapes(world));
  for (const double time : times) {
    goTo(world, time, maxSeconds, trial, seconds);
    trial.shapes.push_back(takeShapes(world));
    trial.born = world.lineage.entries;
    trial.divisions = world.divisions;
  }
}

void addChanges(const OtherModel& other, std::vector<std::string>& changes) {
  const auto take = [&](const char* path) { changes.push_back(fmt::format("{}=null", path)); };
  changes.push_back(fmt::format("physics.cell.model={}", nameOf(other.model)));
  take("physics.membrane");
  take("physics.pressure");
  if (kindOf(other.model).hasRestShape) {
    const auto give = [&](const char* key, double value) {
      changes.push_back(fmt::format("physics.shape-matching.{}={}", key, numberText(value)));
    };
    give("stiffness", other.matched.stiffness);
    give("linear", other.matched.linear);
    give("damping", other.matched.damping);
  } else {
    for (const char* path : {"physics.shape-matching", "physics.mesh.coarsen", "physics.contact.radius"}) take(path);
  }
}

}  // namespace

Setting settingOf(const Scenario& scenario, double timeStep) {
  const MechanicsScene& m = *scenario.scene.mechanics;
  Setting s;
  s.integrator = m.physics.integrator;
  s.timeStep = timeStep;
  s.precision = m.physics.precision;
  s.substeps = m.physics.substeps;
  if (!scenario.mesh.file) s.level = scenario.mesh.icosphere;
  if (m.contact) s.law = m.contact->law;
  return s;
}

Setting settingAsItIs(const Scenario& scenario, double minTimeStep) {
  Setting s = settingOf(scenario, minTimeStep);
  s.automatic = !scenario.scene.mechanics->physics.timeStep;
  s.autoShare = scenario.scene.mechanics->physics.autoShare;
  return s;
}

std::string timeStepChange(const Setting& s) {
  if (!s.automatic) return "physics.time_step=" + exactText(s.timeStep);
  return s.autoShare == 1 ? "physics.time_step=auto" : "physics.time_step.auto=" + exactText(s.autoShare);
}

std::vector<std::string> changesFor(const Setting& s) {
  std::vector<std::string> changes{fmt::format("physics.integrator={}", nameOf(s.integrator)), timeStepChange(s),
                                   fmt::format("physics.precision={}", nameOf(s.precision))};
  if (s.substeps) changes.push_back(fmt::format("physics.substeps={}", *s.substeps));
  if (s.level) changes.push_back(fmt::format("physics.mesh.icosphere={}", *s.level));
  if (s.coarsen) changes.push_back("physics.mesh.coarsen=" + exactText(*s.coarsen));
  if (s.law) changes.push_back(fmt::format("physics.contact.law={}", nameOf(*s.law)));
  if (s.model) addChanges(*s.model, changes);
  return changes;
}

std::string seriesName(const Setting& s, const Setting& usual) {
  std::string text = nameOf(s.integrator);
  if (s.automatic) text += ", automatic";
  if (s.substeps.value_or(1) > 1) text += fmt::format(", {} sub-steps", *s.substeps);
  if (s.level != usual.level && s.level) text += fmt::format(", icosphere {}", *s.level);
  if (s.precision != usual.precision) text += fmt::format(", {}", nameOf(s.precision));
  if (s.law != usual.law && s.law) text += fmt::format(", {} contact", nameOf(*s.law));
  if (s.model) text += fmt::format(", {}", nameOf(s.model->model));
  return text;
}

Trial runTrial(const ReadScenario& read, const Setting& setting, const std::vector<double>& times,
               const Execution& execution, int rounds, double maxSeconds) {
  std::vector<double> seconds;
  Trial trial;
  for (int round = 0; round < rounds && trial.failure.empty(); ++round) {
    trial = {};
    trial.setting = setting;
    double took = 0;
    try {
      runOnce(read(changesFor(setting)).scene, times, execution, maxSeconds, trial, took);
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
  EventFinder finder(world);
  while (!finished(world) && !(latest && world.clock.time >= *latest)) {
    const double apart = twins.step();
    horizon.parted = apart > amplification * twins.ulp();
    if (horizon.parted) break;
    horizon.rounding = std::max(horizon.rounding, apart);
    horizon.end = world.clock.time;
    horizon.vertices = world.bodies->livingVertices;
    finder.look(world);
    horizon.minTimeStep = std::min(horizon.minTimeStep, world.clock.timeStep);
    horizon.maxTimeStep = std::max(horizon.maxTimeStep, world.clock.timeStep);
  }
  horizon.events = finder.events();
  return horizon;
}

}  // namespace morula

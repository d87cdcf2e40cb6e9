#include "loop/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "base/error.h"
#include "diagnose/diagnose.h"
#include "physics/integrator.h"
#include "simulation/memory.h"
#include "simulation/settle.h"
#include "simulation/world.h"
#include "system/console.h"
#include "system/signals.h"
#include "system/usable_memory.h"

namespace morula {
namespace {

// At most so many steps between checks for signals and updates of the progress line.
constexpr std::uint64_t maxStepsAtOnce = 64;

/// The number of steps until the recorder or a hook needs the world.
std::uint64_t stepsUntilLook(const World& world, const Recorder& recorder, const RunOptions& hooks) {
  std::uint64_t steps = std::min(maxStepsAtOnce, recorder.stepsUntilDue(world));
  if (hooks.watch) steps = std::min(steps, hooks.stepsUntilWatch ? hooks.stepsUntilWatch(world) : 1);
  if (hooks.keepEvery > 0) steps = std::min(steps, hooks.keepEvery - world.clock.step % hooks.keepEvery);
  return steps;
}

/// Ends the run if its records, which stay in memory until it ends, take more than half of the memory limit.
void requireMemoryForRecords(const World& world, const Recorder& recorder) {
  const double most = world.execution.memoryLimit / 2;
  if (recorder.bytes() <= most) return;
  throw NumericalError("", world.clock.step,
                       "samples, surfaces and hashes take " + bytesText(recorder.bytes()) +
                           ", more than half of the memory limit of " + bytesText(world.execution.memoryLimit),
                       "record less often (record.every, record.meshes), stop earlier, or raise --memory-limit",
                       Want::memory);
}

}  // namespace

Progress::Progress(std::string label, bool quiet) : label_(std::move(label)), line_(quiet), lastShown_(Clock::now()) {}

void Progress::show(const World& world) {
  // A look at the clock costs as much as a small part of the shortest step; 16 steps are shorter than an eye
  // can follow unless they are so long that the look costs nothing.
  if ((++calls_ % 16 != 0 && world.cells.path.size() < 64) || !line_.isDue()) return;
  const auto now = Clock::now();
  const double seconds = std::chrono::duration<double>(now - lastShown_).count();
  const auto step = static_cast<double>(world.clock.step);
  line_.show(text(world, (step - lastStep_) / seconds, (world.clock.time - lastTime_) / seconds));
  lastShown_ = now;
  lastTime_ = world.clock.time;
  lastStep_ = step;
}

std::string Progress::text(const World& world, double stepsPerSecond, double timePerSecond) const {
  const auto end = plannedEnd(world.model);
  std::string text = label_;
  if (end) text += line_.bar(std::clamp(world.clock.time / *end, 0.0, 1.0));
  text += fmt::format("  {} cells", world.cells.path.size());
  if (const auto& most = world.model.stop.cells) text += fmt::format(" of {}", *most);
  text += fmt::format("  time {:.4g}", world.clock.time);
  if (end) text += fmt::format(" of {:.4g}", *end);
  text += fmt::format("  {:.0f} steps/s", stepsPerSecond);
  if (end && timePerSecond > 0) text += "  " + formatDuration((*end - world.clock.time) / timePerSecond) + " left";
  return text;
}

World makeScenarioWorld(const Scenario& scenario, const Execution& execution) {
  try {
    Execution limited = execution;
    if (std::isinf(limited.memoryLimit)) limited.memoryLimit = usableMemory();
    return makeWorld(scenario.scene, limited);
  } catch (const InputError& error) {
    // The simulator names parameters, as in "physics.time_step 0.02 is above …", but not their file and line: add
    // these.
    const std::string what = error.what();
    const auto path = what.substr(0, what.find(' '));
    const auto place = scenario.places.find(path);
    if (place == scenario.places.end()) throw InputError(scenario.file + ": " + what, error.want);
    throw InputError(
        place->second + ": " + (place->second.ends_with(path) ? "" : path + ": ") + what.substr(path.size() + 1),
        error.want);
  }
}

Execution otherExecution(const Execution& how) {
  Execution other = how;
  other.threads = how.threads == 1 ? 2 : 1;
  const auto isas = availableIsas();
  const auto place = std::find(isas.begin(), isas.end(), how.isa);
  if (isas.size() > 1) other.isa = place == isas.begin() ? isas[1] : *(place - 1);
  return other;
}

std::uint64_t stepsPerHashOf(const Scene& scene) {
  return scene.mechanics && !kindOf(scene.mechanics->physics.integrator).settles ? stepsPerHash : 1;
}

bool wantsHashes(const Scenario& scenario, bool hasGolden) { return hasGolden || scenario.places.contains("check"); }

RunRecord recordOf(const Scenario& scenario, const Execution& execution, const std::string& command) {
  RunRecord record;
  record.scenario = scenario.scene.name;
  record.scenarioHash = scenario.meaning.text();
  if (scenario.referenceMeaning) record.referenceHash = scenario.referenceMeaning->text();
  record.seed = scenario.scene.seed;
  record.documents = {{"scenario", scenario.file, scenario.bytes}, {"resolved", "", scenario.resolved}};
  for (const auto& file : scenario.files) record.documents.push_back({file.role, file.path, file.content});
  if (!buildDiff().empty()) record.documents.push_back({"diff", "", buildDiff()});
  record.command = command;
  record.isa = name(execution.isa);
  record.threads = execution.threads;
  return record;
}

RecordOptions recordingOf(const Scenario& scenario, bool hashes) {
  RecordOptions record{.every = scenario.record.every,
                       .atCells = scenario.record.atCells,
                       .measures = scenario.record.measures,
                       .reference = scenario.check.reference,
                       .nameOf = scenario.names.function(),
                       .meshes = scenario.record.meshes};
  if (hashes) record.hashEvery = stepsPerHashOf(scenario.scene);
  return record;
}

Simulation simulate(const Scenario& scenario, const Execution& how, RunOptions options) {
  return simulate(scenario, makeScenarioWorld(scenario, how), std::move(options));
}

Simulation simulate(const Scenario& scenario, World world, RunOptions options) {
  if (options.label.empty()) options.label = scenario.scene.name;
  options.record.nameOf = scenario.names.function();
  Recorder recorder(options.record, options.sink);
  return simulate(std::move(world), std::move(recorder), options);
}

Simulation simulate(World world, Recorder recorder, const RunOptions& options, bool resumed) {
  Simulation run{std::move(world), {}, {}, 0};
  Progress progress(options.label, options.quiet);
  const auto observe = [&] {
    recorder.observe(run.world);
    requireMemoryForRecords(run.world, recorder);
    if (options.watch) options.watch(run.world);
    progress.show(run.world);
  };

  const SignalWatch signals;
  auto status = RunStatus::done;
  std::string failure;
  Want want = Want::nothing;
  const auto fail = [&](const std::string& why, Want missing) {
    status = RunStatus::failed, failure = withNames(why, recorder.options().nameOf), want = missing;
  };
  try {
    if (!resumed) observe();
    while (!finished(run.world)) {
      if ((run.signal = SignalWatch::caught()) != 0) {
        status = RunStatus::killed;
        if (options.keep) options.keep(run.world, recorder);
        break;
      }
      takeSteps(run.world, stepsUntilLook(run.world, recorder, options));
      observe();
      if (options.keepEvery > 0 && run.world.clock.step % options.keepEvery == 0) options.keep(run.world, recorder);
    }
    run.end = endOf(run.world, status);  // hashes the state; throws NumericalError if a number is not finite
  } catch (const BodyFailure& error) {
    // `diagnose` asks which force drove a cell over the last time steps; settling has no time steps.
    fail(settles(run.world) ? error.what() : diagnose(run.world.model, run.world.execution, error), error.want);
  } catch (const NumericalError& error) { fail(error.what(), error.want); } catch (const std::bad_alloc&) {
    fail(fmt::format("step {}: there is no more memory; {}", run.world.clock.step, outOfMemoryRemedy), Want::memory);
  } catch (const InputError& error) { fail(error.what(), error.want); } catch (const FileError& error) {
    if (!recorder.hasSink()) throw;
    fail(error.what(), Want::files);
    run.error = std::current_exception();
  } catch (const std::exception& error) {
    if (!recorder.hasSink()) throw;
    fail(std::string("a bug of Morula's: ") + error.what(), Want::reason);
    run.error = std::current_exception();
  }
  if (status == RunStatus::failed) run.end = endOf(run.world, status, failure, want);
  run.results = recorder.take(run.world, status == RunStatus::failed);
  return run;
}

void requireEnough(const RunEnd& end) {
  if (end.want != Want::nothing) throw NumericalError(end.failure, end.want);
}

}  // namespace morula

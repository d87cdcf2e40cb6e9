#include "run/run_scenario.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "check/against.h"
#include "check/check_run.h"
#include "check/remarks.h"
#include "files/folders.h"
#include "golden/accept.h"
#include "loop/run.h"
#include "loop/samples.h"
#include "pictures/pictures.h"
#include "run/checkpoints.h"
#include "run/draw_run.h"
#include "run/run_file.h"
#include "values/parameter.h"

namespace morula {
namespace {

/// Adds what was checked of the run to its outcome and to its results.
void judge(const Scenario& scenario, const RunSettings& settings, CheckedRun& checked, RunOutcome& outcome) {
  const RunEnd& end = checked.run.end;
  const bool hasGolden = fileExists(goldenFile(scenario));
  if (end.status == RunStatus::killed) {  // nothing is checked
  } else if (!settings.check) outcome.whyNotChecked = "as asked";
  else if (settings.changed) outcome.whyNotChecked = "the scene was changed by --set or --seed";
  else if (end.status == RunStatus::failed) {
    if (!scenario.check.fails.empty()) outcome.checks = checkStop(scenario, end.failure);
  } else if (!hasGolden && !Invariants::areGiven(scenario.check)) outcome.whyNotChecked = "there is no golden file";
  else
    outcome.checks =
        check(scenario, checked, hasGolden ? observe(scenario, checked.run, settings.draw) : GoldenData{}, false);
  outcome.sanity = std::move(checked.sanity);
  std::vector<CheckResult>& all = checked.run.results.checks;
  if (outcome.checks) all = outcome.checks->results;
  all.insert(all.end(), outcome.sanity.begin(), outcome.sanity.end());
}

/// Adds what people are told about the run besides its checks.
void addRemarks(const Scenario& scenario, const World& world, RunOutcome& outcome) {
  outcome.ambiguous = ambiguousDivisions(
      world.model, world.lineage.entries, [&](StateId state) { return world.biology->describe(state); },
      world.divisions);
  if (world.stoppedBy) outcome.stopped = scenario::stopText(scenario.scene.stop.when[*world.stoppedBy], scenario.names);
  if (world.experiments) outcome.experiments = experimentLines(scenario, *world.experiments);
  if (world.settlings) {
    outcome.unsettled = unsettledText(world.bodies->parameters, *world.settlings);
    outcome.settled = settledText(world.bodies->parameters, *world.settlings);
  }
  if (outcome.end.status == RunStatus::done) outcome.reference = positionsText(world, scenario);
}

}  // namespace

std::optional<bool> RunOutcome::isSane() const {
  if (sanity.empty()) return {};
  return std::all_of(sanity.begin(), sanity.end(), [](const CheckResult& r) { return r.passed; });
}

ResultState RunOutcome::state() const {
  if (end.status == RunStatus::failed) return ResultState::failed;
  if (end.status != RunStatus::done) return ResultState::unfinished;
  ResultState worst = checks && whyNotChecked.empty() ? ResultState::fine : ResultState::unchecked;
  if (checks && !checks->results.empty()) worst = std::max(worst, stateOf(*checks));
  return sanity.empty() ? worst : std::max(worst, stateOf(sanity));
}

CheckReport RunOutcome::sanityReport(const Scenario& scenario) const { return {goldenName(scenario.file), sanity}; }

RunOutcome runScenario(const Scenario& scenario, const RunSettings& settings) {
  const bool hasGolden = settings.isChecked() && fileExists(goldenFile(scenario));
  const RecordOptions recording =
      recordingOf(scenario, settings.hashes.value_or(settings.isChecked() && wantsHashes(scenario, hasGolden)));
  Run run(makeScenarioWorld(scenario, settings.execution),
          {.label = scenario.scene.name + " " + std::to_string(scenario.scene.seed),
           .quiet = settings.quiet,
           .nameOf = recording.nameOf,
           .storesRecords = true});
  RunChecks checks(scenario, run.world(), settings.isChecked());
  RunFile file(scenario, settings, hasGolden);
  Samples samples(recording, file.sink());
  FrameCollector frames(scenario, settings.draw ? scenario.record.pictures : std::nullopt);
  Checkpoints checkpoints(file.store(), file.id(), samples, frames, settings.checkpointEvery, settings.quiet);
  for (Observer* observer : std::initializer_list<Observer*>{&samples, &frames, &checks, &checkpoints})
    run.watch(*observer);
  std::optional<Against> against;
  if (settings.against) run.watch(against.emplace(settings.against->stages));

  RunOutcome outcome;
  outcome.id = file.id();
  outcome.resumedAt = file.begin(run, recording);
  outcome.mother = file.mother();
  outcome.end = run.toEnd();
  RunResults results = samples.take(run.world(), outcome.end);
  if (against && outcome.end.status == RunStatus::done) results.against = against->take(run.world());
  outcome.against = results.against;
  CheckedRun ended = checks.of({run.takeWorld(), outcome.end, std::move(results), file.takeKept()});
  const Simulation& simulation = ended.run;
  const bool done = outcome.end.status == RunStatus::done;
  outcome.canBeResumed = (checkpoints.kept() || outcome.resumedAt) &&
                         (outcome.end.status == RunStatus::killed || outcome.end.want != Want::nothing);
  if (done && !simulation.results.samples.empty()) outcome.last = simulation.results.samples.back();
  judge(scenario, settings, ended, outcome);
  outcome.database = file.finish(outcome.end, simulation.results, checkpoints.beforeEnd());
  if (run.error()) std::rethrow_exception(run.error());
  addRemarks(scenario, simulation.world, outcome);
  if (done) drawRun(scenario, settings, simulation, frames, file.store(), outcome);
  return outcome;
}

}  // namespace morula

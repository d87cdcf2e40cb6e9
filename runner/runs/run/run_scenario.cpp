#include "run/run_scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "base/error.h"
#include "check/beside_golden.h"
#include "check/check_run.h"
#include "check/remarks.h"
#include "check/sanity.h"
#include "database/store_error.h"
#include "drawing/png_file.h"
#include "engines/bullet_check.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "golden/accept.h"
#include "pictures/frame_file.h"
#include "pictures/pictures.h"
#include "simulation/checkpoint.h"
#include "store/recorder.h"
#include "store/store.h"
#include "system/console.h"
#include "system/folder_lock.h"
#include "system/json.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// Lists the differences of two records that make their run ids differ.
std::string differences(const RunRecord& there, const RunRecord& here) {
  std::string text;
  for (const auto& [name, item, before, now] : compareIdentity(there, here))
    if (before != now) text += (text.empty() ? "" : "; ") + fmt::format("{} ({} then, {} now)", item, before, now);
  return text;
}

/// All values of a resolved scenario by their keys, "stop.cycles".
Json valuesOf(const RunRecord& record) {
  for (const SourceText& d : record.documents)
    if (d.role == "resolved")
      if (const Json json = tryParseJson(d.content); json.is_object()) return json.flatten();
  return Json::object();
}

/// The keys that differ between two scenarios, with both values.
std::string keysThatDiffer(const RunRecord& there, const RunRecord& here) {
  const Json before = valuesOf(there), now = valuesOf(here);
  std::set<std::string> keys;
  for (const Json* values : {&before, &now})
    for (const auto& [key, value] : values->items()) keys.insert(key);
  const auto text = [](const Json& values, const std::string& key) {
    return values.contains(key) ? jsonText(values[key]) : std::string("nothing");
  };
  std::string found;
  for (const std::string& key : keys) {
    if (text(before, key) == text(now, key)) continue;
    std::string path = key.substr(1);
    std::ranges::replace(path, '/', '.');
    found += (found.empty() ? "" : "; ") + path + ": " + text(before, key) + " then, " + text(now, key) + " now";
  }
  return found;
}

/// Why there is nothing to go on from.
std::string whyNot(Store& store, const RunRecord& record) {
  const std::string id = runId(record);
  std::optional<StoredRun> other;
  for (const StoredRun& run : store.runs()) {
    if (run.id == id && run.status == RunStatus::done) return "run " + id + " is finished";
    if (run.id == id) return "run " + id + " left no checkpoint (--checkpoint-every makes them)";
    if (run.record.scenario == record.scenario && run.status != RunStatus::done) other = run;
  }
  if (other) {
    RunRecord there = other->record;
    there.documents = store.documents(other->id);
    if (const std::string keys = keysThatDiffer(there, record); !keys.empty())
      return "run " + other->id + " of " + record.scenario + " is of another scenario (" + keys + ")";
    return "run " + other->id + " of " + record.scenario +
           " is another one; what differs: " + differences(other->record, record);
  }
  return "there is no unfinished run of " + record.scenario + " in " + store.file().string();
}

std::string samplesOf(const std::optional<double>& every) {
  return every ? fmt::format("samples every {}", *every) : "samples at start and end";
}

std::string hashesOf(const std::optional<std::uint64_t>& every) {
  return every ? fmt::format("state hashes every {}", *every) : "no state hashes";
}

/// Throws if the checkpoint's run was recorded in another way, for its records could not be completed.
void requireSameRecords(const Checkpoint& c, const RecordOptions& now) {
  if (c.every == now.every && c.hashEvery == now.hashEvery) return;
  throw UsageError(fmt::format(
      "--resume: the checkpoint was made with {} and {}, and now it is {} and {}; record as then (--no-check and the "
      "scenario's record and check decide), or leave out --resume to start from the beginning",
      samplesOf(c.every), hashesOf(c.hashEvery), samplesOf(now.every), hashesOf(now.hashEvery)));
}

/// Puts world, recorder and frames where the run's last checkpoint left them, and returns its step. Without a
/// checkpoint nothing changes, and stderr says why there is none: which runs there are, and what differs.
/// Throws FileError for a checkpoint that cannot be used, UsageError if it was made with other records.
std::optional<std::uint64_t> resumeRun(Store& store, const RunRecord& record, World& world, Recorder& recorder,
                                       FrameCollector& frames, bool quiet) {
  const auto run = store.resume(record);
  if (!run) {
    tell("nothing to resume: " + whyNot(store, record) + "; starting from the beginning", quiet);
    return std::nullopt;
  }
  requireSameRecords(run->checkpoint, recorder.options());
  try {
    restoreState(world, run->checkpoint.state);
    store.eachRecord(run->id, [&](const RunResults& records) { recorder.resume(world, records); });
    frames.resume(world, run->frames);
  } catch (const InputError& error) {
    throw FileError(store.file().string() + ": run " + run->id + " cannot be resumed: " + error.what() +
                    "; leave out --resume to start from the beginning");
  }
  tell(fmt::format("{} goes on from step {}, time {:.6g}", record.scenario, world.clock.step, world.clock.time), quiet);
  return world.clock.step;
}

/// Keeps, of the records that go to the database during the run, those that a golden also has.
void keepForGolden(const RunResults& records, RunResults& kept, RecordedTables& tables) {
  tables.addRecords(records);
  for (const Sample& s : records.samples) kept.samples.push_back({s.world, {}, {}});
  kept.chain.insert(kept.chain.end(), records.chain.begin(), records.chain.end());
}

void checkOutcome(const Scenario& scenario, const RunSettings& settings, const CheckedRun& checked,
                  RunOutcome& outcome) {
  const RunEnd& end = checked.run.end;
  const bool hasGolden = fileExists(goldenFile(scenario));
  if (!settings.check) outcome.whyNotChecked = "as asked";
  else if (settings.changed) outcome.whyNotChecked = "the scene was changed by --set or --seed";
  else if (end.status == RunStatus::failed) {
    if (!scenario.check.fails.empty()) outcome.checks = checkStop(scenario, end.failure);
  } else if (!hasGolden && !Invariants::areGiven(scenario.check)) outcome.whyNotChecked = "there is no golden file";
  else
    outcome.checks =
        check(scenario, checked, hasGolden ? observe(scenario, checked.run, settings.draw) : GoldenData{}, false);
}

/// Called after the run is stored, so that a failure of Bullet loses nothing.
void besideBullet(const Scenario& scenario, const RunSettings& settings, const Simulation& run, Store& store,
                  RunOutcome& outcome) {
  if (!scenario.check.bullet || !settings.check || settings.changed) return;
  const BulletFindings found = checkAgainstBullet(scenario, run.world, settings.quiet);
  if (!outcome.checks) outcome.checks = CheckReport{goldenName(scenario.file), {}};
  outcome.checks->results.insert(outcome.checks->results.end(), found.results.begin(), found.results.end());
  store.addChecks(outcome.id, found.results);
  if (!found.bullet) return;
  store.putBulletSamples(outcome.id, name(scenario.check.bullet->baseline), found.bullet->samples);
  if (!settings.draw) return;
  const FolderLock lock(settings.folder);
  outcome.pictures.push_back((settings.folder / "bullet.png").string());
  writePicture(comparisonSheet(imagesBesideBullet(run.world, found.bullet->shapes, scenario)), outcome.pictures.back());
}

/// Writes golden.png (the accepted result, this one, and their distance) if the run differs from its golden; otherwise
/// removes the one of an earlier run.
void besideGolden(const Scenario& scenario, const RunSettings& settings, const Simulation& run, RunOutcome& outcome) {
  const auto file = settings.folder / "golden.png";
  const bool differs =
      outcome.checks && std::any_of(outcome.checks->results.begin(), outcome.checks->results.end(),
                                    [](const CheckResult& r) { return !r.passed && r.kind == "golden"; });
  const auto beside =
      differs ? drawBesideGoldenFile(scenario, run.world, settings.execution, settings.quiet) : std::nullopt;
  const FolderLock lock(settings.folder);
  if (beside && beside->signal == 0) {
    writePicture(beside->sheet(), file);
    outcome.pictures.push_back(file.string());
  } else if (fileExists(file) && isOwnPng(readHead(file, 64))) {
    removeFile(file);
  }
  if (beside && beside->signal) outcome.signal = beside->signal;
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
  auto world = makeScenarioWorld(scenario, settings.execution);
  const bool checked = settings.check && !settings.changed;
  RunChecks checks(scenario, world, checked);
  // Open all files before the first step, so that errors of files are found before time is spent.
  makeFolder(settings.database.parent_path());
  auto store = Store::openForWriting(settings.database);
  if (settings.draw) makeFolder(settings.folder);

  const auto record = recordOf(scenario, settings.execution, settings.command);
  RunOutcome outcome;
  outcome.id = runId(record), outcome.database = settings.database;
  RunResults passed;
  RecordedTables passedTables;
  const bool hasGolden = checked && fileExists(goldenFile(scenario));
  Recorder recorder(recordingOf(scenario, checked && wantsHashes(scenario, hasGolden)), [&](const RunResults& records) {
    store.record(outcome.id, records);
    if (hasGolden) keepForGolden(records, passed, passedTables);
  });
  FrameCollector frames(scenario, settings.draw ? scenario.record.pictures : std::nullopt);
  if (settings.resume) outcome.resumedAt = resumeRun(store, record, world, recorder, frames, settings.quiet);
  if (!outcome.resumedAt) store.begin(record);
  if (const auto step = store.checkpointStep(outcome.id); step && !settings.resume)
    tell(fmt::format("an earlier attempt was stopped at step {}: --resume goes on from there", *step), settings.quiet);

  const auto keep = [&](const World& w, const Recorder& r) {
    try {
      outcome.canBeResumed = store.keepCheckpoint(
          outcome.id, {w.clock.step, r.options().every, r.options().hashEvery, saveState(w)}, r.records(),
          {frames.frames().size(), [&](auto i) { return frameBytes(frames.frames()[i]); }});
    } catch (const BusyError& error) { tell(std::string("no checkpoint was made: ") + error.what(), settings.quiet); }
  };
  RunOptions options{.label = scenario.scene.name + " " + std::to_string(scenario.scene.seed),
                     .quiet = settings.quiet,
                     .watch = checks.watch(),
                     .keep = keep,
                     .keepEvery = settings.checkpointEvery};
  if (settings.draw && scenario.record.pictures) {
    // Checks see every step. Frames alone leave isolated cells to make many steps at once.
    if (!options.watch) options.stepsUntilWatch = [&frames](const World& w) { return frames.stepsUntilDue(w); };
    options.watch = [&frames, others = options.watch](const World& w) {
      frames.observe(w);
      if (others) others(w);
    };
  }
  CheckedRun ended = checks.of(simulate(std::move(world), std::move(recorder), options, outcome.resumedAt.has_value()));
  Simulation& run = ended.run;
  run.passed = std::move(passed), run.passedTables = std::move(passedTables);

  outcome.end = run.end;
  outcome.canBeResumed = (outcome.canBeResumed || outcome.resumedAt) &&
                         (run.end.status == RunStatus::killed || run.end.want != Want::nothing);
  const bool done = run.end.status == RunStatus::done;
  if (done && !run.results.samples.empty()) outcome.last = run.results.samples.back();
  if (run.end.status != RunStatus::killed) checkOutcome(scenario, settings, ended, outcome);
  outcome.sanity = std::move(ended.sanity);
  if (outcome.checks) run.results.checks = outcome.checks->results;
  run.results.checks.insert(run.results.checks.end(), outcome.sanity.begin(), outcome.sanity.end());
  try {
    store.finish(outcome.id, run.end, run.results);
  } catch (const BusyError& error) {
    store = store.finishBeside(outcome.id, run.end, run.results);
    outcome.database = store.file();
    tellError(fmt::format("{}; the run is stored in {}", error.what(), outcome.database.string()));
  }
  if (run.error) std::rethrow_exception(run.error);
  outcome.ambiguous = ambiguousDivisions(
      run.world.model, run.world.lineage.entries, [&](StateId state) { return run.world.biology->describe(state); },
      run.world.divisions);
  if (run.world.settlings) outcome.unsettled = unsettledText(run.world.bodies->parameters.settle, *run.world.settlings);
  outcome.signal = run.signal;
  if (!done) return outcome;
  outcome.reference = positionsText(run.world, scenario);
  try {
    if (settings.draw) {
      // Runs with the same folder draw one after the other, so that all pictures are of one run, the last.
      const FolderLock lock(settings.folder);
      outcome.pictures = writePictures(run.world, scenario, frames, settings.folder);
    }
    if (settings.draw) besideGolden(scenario, settings, run, outcome);
    besideBullet(scenario, settings, run, store, outcome);
  } catch (const NumericalError& error) {
    if (error.want == Want::nothing) throw;
    throw NumericalError(fmt::format("{}; run {} is stored in {}", error.what(), outcome.id, outcome.database.string()),
                         error.want);
  }
  return outcome;
}

}  // namespace morula

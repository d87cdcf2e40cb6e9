// morula run: simulate, store, check, draw.
#include <set>
#include <utility>

#include "base/error.h"
#include "check/check_run.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "files/text.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/program.h"
#include "options/verb.h"
#include "run/mother.h"
#include "run/run_scenario.h"
#include "run_verb/run_verb.h"
#include "system/console.h"
#include "system/signals.h"

namespace morula::cli {
namespace {

struct RunOptions {
  std::vector<std::string> scenarios;
  InputOptions input;
  SceneOptions scene;
  ExecutionOptions execution;
  OutputOptions output;
  std::vector<std::uint64_t> seeds;
  std::uint64_t checkpointEvery = 0;
  std::string database, run, out = "results", against;
  tracks::MeasuredOptions measured;
  bool dryRun = false, noCheck = false, noPictures = false, resume = false;
};

struct Planned {
  Scenario scenario;
  RunSettings settings;
};

/// Eight hexadecimal digits of a hash over all values of a scenario.
std::string digits(const Scenario& scenario) { return Hasher().add(scenario.resolved).digest().text().substr(0, 8); }

/// Returns true if the last run of this name and seed in the database is of another scenario file with other values;
/// absent without such a run. If several began in the same second, any of them may be the last.
std::optional<bool> isOfOther(const std::filesystem::path& database, const Scenario& scenario) {
  if (database.empty() || !fileExists(database)) return {};
  try {
    auto store = Store::openForReading(database);
    std::vector<StoredRun> last;
    for (const StoredRun& run : store.runs()) {
      if (run.record.scenario != scenario.scene.name || run.record.seed != scenario.scene.seed) continue;
      if (!last.empty() && run.started > last[0].started) last.clear();
      last.push_back(run);
    }
    if (last.empty()) return {};
    for (const StoredRun& run : last)
      for (const SourceText& d : store.documents(run.id))
        if ((d.role == "scenario" && absolutePath(d.path) == absolutePath(scenario.file)) ||
            (d.role == "resolved" && d.content == scenario.resolved))
          return false;
    return true;
  } catch (const FileError&) { return {}; }  // the error is reported when the run opens the database for writing
}

/// Returns true if the folder may hold results of another file with this name and seed. If its pictures are of a run
/// that is stored elsewhere, only the database of --db shows whose they are.
bool isTaken(const std::filesystem::path& folder, const std::filesystem::path& database, const Scenario& scenario) {
  const auto inside = isOfOther(folder / "run.db", scenario), given = isOfOther(database, scenario);
  return inside.value_or(false) || given.value_or(false) ||
         (!database.empty() && !inside && !given && fileExists(folder));
}

/// "unique-four-20080617": name and seed. Eight digits follow if values were changed by --set, and if there is a
/// `twin`: another file of the same name and seed, run in the same call or before. So each has a folder of its own.
std::string folderName(const Scenario& scenario, const SceneOptions& scene, bool twin) {
  const std::string name = scenario.scene.name + "-" + std::to_string(scenario.scene.seed);
  return scene.set.empty() && !twin ? name : name + '-' + digits(scenario);
}

/// Reads the table of measured cells that runs of the scenario are compared with.
std::optional<tracks::MeasuredCells> readAgainst(const RunOptions& options, const Scenario& scenario) {
  if (options.against.empty()) return {};
  if (!scenario.scene.mechanics)
    throw InputError(scenario.file +
                     ": its cells have no places, and --against compares places; needs a physics block");
  return tracks::readMeasured(readFile(options.against, maxTableBytes), options.against, scenario.names, scenario.units,
                              options.measured);
}

/// Returns a run that goes on with what a run of the database was, with the changes of --set.
Planned goOn(const std::string& database, const RunOptions& options) {
  if (!options.resume)
    throw UsageError("run: '" + database + "' is a database; --resume goes on with its run, morula replay repeats it");
  if (options.scene.seed || !options.seeds.empty())
    throw UsageError("--resume: the seed of a run decides it from its start; run the scenario with the other seed");
  if (!options.database.empty())
    throw UsageError("--db: a run that goes on is stored beside the other one, in '" + database + "'; leave out --db");
  Store store = Store::openForReading(database);
  const StoredRun run = store.find(options.run);
  requireWholeRecord(store, run);
  const Execution how = execution(options.execution);
  Planned planned{scenarioGoingOn(store, run, overrides(options.scene), how),
                  {.execution = how, .folder = {}, .database = database}};
  const auto checkpoint = store.checkpointOf(run.id);
  // Hashes on the way count experiments from the first one of a scene on.
  const bool isFirst =
      !planned.scenario.scene.experiments.empty() && storedScenario(database, run.id).scene.experiments.empty();
  planned.settings.mother = run.id;
  planned.settings.hashes = checkpoint && checkpoint->hashEvery && !isFirst;
  return planned;
}

/// All runs of the call. Every scenario is read and checked before the first step of the first run.
std::vector<Planned> plan(const RunOptions& options) {
  std::vector<std::optional<std::uint64_t>> seeds(options.seeds.begin(), options.seeds.end());
  if (seeds.empty()) seeds = {options.scene.seed};
  std::vector<Planned> runs;
  const auto add = [&](Planned run, bool changed) {
    RunSettings& s = run.settings;
    s.command = commandLine();
    s.changed = changed;
    s.check = !options.noCheck;
    s.draw = !options.noPictures;
    s.quiet = options.output.quiet;
    s.checkpointEvery = options.checkpointEvery;
    s.resume = options.resume;
    runs.push_back(std::move(run));
  };
  for (const auto& file : options.scenarios) {
    if (isDatabase(file)) {
      add(goOn(file, options), true);
      continue;
    }
    if (!options.run.empty())
      throw UsageError("--run chooses a run of a database, and '" + file + "' is not a database");
    for (const auto& seed : seeds) {
      auto scene = options.scene;
      scene.seed = seed;
      Scenario scenario = loadScenario(file, overrides(scene), options.input.allowOutside);
      std::optional<tracks::MeasuredCells> against = readAgainst(options, scenario);
      add({std::move(scenario),
           {.execution = execution(options.execution),
            .folder = {},
            .database = options.database,
            .against = std::move(against)}},
          !scene.empty());
    }
  }
  std::map<std::string, std::set<std::string>> places;  // by name and seed
  const auto key = [](const Scenario& s) { return s.scene.name + '-' + std::to_string(s.scene.seed); };
  for (const Planned& run : runs) places[key(run.scenario)].insert(run.scenario.resolved);
  for (Planned& run : runs) {
    const auto folder = [&](bool twin) {
      return std::filesystem::path(options.out) / folderName(run.scenario, options.scene, twin);
    };
    const bool twin = places[key(run.scenario)].size() > 1 || isTaken(folder(false), options.database, run.scenario);
    run.settings.folder = folder(twin);
    if (run.settings.database.empty()) run.settings.database = run.settings.folder / "run.db";
  }
  return runs;
}

Json describePlan(const Planned& run) {
  const auto end = plannedEnd(run.scenario.scene);
  return {{"scenario", run.scenario.scene.name},
          {"seed", run.scenario.scene.seed},
          {"seed_matters", usesSeed(run.scenario.scene)},
          {"status", "planned"},
          {"until", end ? Json(*end) : Json()},
          {"scenario_hash", run.scenario.meaning.text()},
          {"db", run.settings.database.string()},
          {"pictures", run.settings.draw ? Json(run.settings.folder.string()) : Json()}};
}

std::string describePlanForPeople(const Planned& run) {
  const auto plan = describePlan(run);
  return run.scenario.scene.name + "  seed " + std::to_string(run.scenario.scene.seed) + ": would run" +
         (plan["until"].is_null() ? "" : " until time " + jsonText(plan["until"])) + "\n  results  " +
         run.settings.database.string() + "\n";
}

/// Warns where seeds change nothing, so that ten equal results are not taken for ten samples.
void tellIfSeedsDoNotMatter(const RunOptions& options, const std::vector<Planned>& runs) {
  if (options.seeds.empty() && !options.scene.seed) return;
  const Planned* told = nullptr;
  for (const auto& run : runs) {
    if ((told && told->scenario.file == run.scenario.file) || usesSeed(run.scenario.scene)) continue;
    told = &run;
    tell(run.scenario.file + ": nothing in this scenario is random, so every seed gives the same result; " +
             (run.scenario.scene.mechanics ? "division.plane: random, a tilt in division.rules or variation"
                                           : "variation: {cycle: 0.05}, or with a physics block "
                                             "division.plane: random,") +
             " would make seeds differ where cells divide",
         options.output.quiet);
  }
}

int exitCodeOf(const RunOutcome& outcome, const RunSettings& settings) {
  if (outcome.end.status == RunStatus::killed) return signalled + SignalWatch::caught();
  const auto code = exitCodeOfRun(outcome.state());
  // A run that is fine is not where it was asked for.
  return code == fine && outcome.database != settings.database ? file : code;
}

int act(const RunOptions& options) {
  auto runs = plan(options);
  tellIfSeedsDoNotMatter(options, runs);
  std::string warned;
  for (const auto& run : runs) {
    if (std::exchange(warned, run.scenario.file) == run.scenario.file) continue;
    tellWarnings(run.scenario.warnings, options.output.quiet);
    if (!run.settings.against) continue;
    for (const std::string& sentence : run.settings.against->told)
      tell(options.against + ": " + sentence, options.output.quiet);
  }
  Json list = Json::array();
  int code = fine;
  for (const auto& run : runs) {
    if (options.dryRun) {
      makeScenarioWorld(run.scenario, run.settings.execution);  // throws if the time step is above its limit
      if (options.output.json) list.push_back(describePlan(run));
      else print(describePlanForPeople(run));
      continue;
    }
    const auto outcome = runScenario(run.scenario, run.settings);
    const int exitCode = exitCodeOf(outcome, run.settings);
    code = std::max(code, exitCode);
    if (options.output.json) list.push_back(toJson(outcome, run.scenario));
    else print(describe(outcome, run.scenario, run.settings));
    if (outcome.checks && !outcome.checks->passed() && options.output.json)
      tell(describe(*outcome.checks), options.output.quiet);
    if (!outcome.isSane().value_or(true) && options.output.json)
      tell(describe(outcome.sanityReport(run.scenario)), options.output.quiet);
    if (!outcome.end.failure.empty()) tellError(outcome.end.failure);
    if (exitCode > signalled) break;
  }
  if (options.output.json) printJson(runs.size() == 1 ? list[0] : Json{{"runs", list}});
  return code;
}

}  // namespace

void addRun(CLI::App& app, Action& action) {
  Verb verb(app, action, "run", "Simulate a scenario, and store, check and draw the run");
  auto& options = verb.does<RunOptions>(act);
  verb.needs("scenario", options.scenarios, "FILE",
             "Scenario files; with --resume also a database, to go on with its run");
  add(verb, options.input);
  add(verb, options.scene);
  verb.takes<std::vector<std::uint64_t>>("--seeds", options.seeds, "FIRST..LAST", readSeeds,
                                         "Run once for each seed of a range: 1..50");
  verb.takes("--db", options.database, "FILE", "Store in this file; default: run.db beside the pictures");
  verb.takes("--out", options.out, "FOLDER", "Folder for results, with one folder for each run");
  verb.takes("--no-pictures", options.noPictures, "Draw no pictures, not even the one of the golden file");
  verb.takes("--no-check", options.noCheck, "Do not compare with the golden file");
  verb.takes("--checkpoint-every", options.checkpointEvery, "STEPS", natural(1, 1'000'000'000'000),
             "Number of steps between checkpoints; a checkpoint is always kept at Ctrl-C");
  verb.showDefault("--checkpoint-every", "");
  verb.takes("--resume", options.resume,
             "Continue from the last checkpoint of the same run, or go on from a run that has ended: with a later stop "
             "(--set stop.time=8), and with what changes then (--set physics.drag=5)");
  addRunChoice(verb, options.run);
  verb.takes("--dry-run", options.dryRun, "Read and check the scenarios; run nothing and write nothing");
  verb.takes("--against", options.against, "TABLE",
             "Compare the cells' places with measured ones: CSV with a row per cell and stage (cells or time; name or "
             "path; x, y, z; contacts), or tracks as init --from reads them");
  verb.takes(
      "--against-units", options.measured.units, "LENGTH,TIME",
      [](const std::string& text) { return text == "scene" ? Units{} : readUnits(text); },
      "Units of the table, as µm,min or 0.5µm,2min; scene: the scenario's own; default: its units");
  verb.takes("--columns", options.measured.columns, "NAME=HEADER", readColumns,
             "Headers of the table's columns, as x=POSITION_X,name=CELL");
  verb.onlyWith({"--against-units", "--columns"}, {"--against"});
  verb.excludes("--against", {"--resume"}, "a run that goes on does not see its earlier stages again");
  verb.oneOf({"--seed", "--seeds"});
  verb.oneOf({"--resume", "--dry-run"});
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli

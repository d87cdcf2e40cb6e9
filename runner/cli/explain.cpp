// morula explain: where and why a result differs.
#include "explain/explain.h"

#include <memory>

#include "base/error.h"
#include "check/accept_run.h"
#include "check/check_run.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/verb.h"
#include "explain/program_run.h"
#include "explain/scenario_run.h"
#include "explain/stored_run.h"
#include "explain/text_difference.h"
#include "files/folders.h"
#include "golden/accept.h"
#include "golden/change.h"
#include "golden/facts.h"
#include "loop/stored_scenario.h"
#include "scenario/deciding_values.h"
#include "store/store.h"
#include "system/console.h"
#include "system/signals.h"

namespace morula::cli {

namespace {

struct ExplainOptions {
  std::string scenario;
  std::string with, database, run, every = "64";
  InputOptions input;
  ExecutionOptions execution;
  OutputOptions output;
};

/// What was found, in the order in which one finding explains the next.
struct Findings {
  std::string failureClass;  // "" if nothing differs
  Explanation where;
  std::vector<KeyChange> changed;
  std::string text;  // for people
  std::vector<CheckResult> checks;
};

std::uint64_t strideOf(const ExplainOptions& options) {
  return naturalOption("--every", options.every, 1, 1'000'000'000);
}

/// Two runs of this program that compute in different ways.
void lookForNondeterminism(const Scenario& scenario, const Execution& how, std::uint64_t every, Findings& f) {
  OwnRun first = scenarioRun(scenario, how), second = scenarioRun(scenario, otherExecution(how));
  f.where = explainTwice(first, second, every);
  f.failureClass = f.where.failureClass;
  f.text += (f.failureClass.empty() ? "two runs of this program: " : "") + f.where.text;
}

std::string resolvedOf(const std::vector<Document>& documents) {
  for (const auto& d : documents)
    if (d.role == "resolved") return d.content;
  return {};
}

/// A stored run as a golden would tell it: what decided it, its lineage, and its cells where it was sampled
/// last if that was its end.
GoldenData dataOf(Store& store, const StoredRun& run, const Scenario& scenario) {
  const RunResults results = store.results(run.id);
  GoldenFacts facts;
  facts.scenario = goldenName(scenario.file), facts.scenarioHash = run.record.scenarioHash;
  facts.seed = run.record.seed, facts.steps = run.steps;
  facts.lineage = results.lineage;
  facts.describe = [&](StateId state) { return results.stateTexts.at(state); };
  if (!results.samples.empty() && results.samples.back().world.step == run.steps) {
    facts.mechanics = !results.samples.back().cells.empty();
    facts.end = results.samples.back().world, facts.cells = results.samples.back().cells;
  }
  GoldenData data = makeGoldenData(facts);
  data.parameters = decidingValues(scenario);
  return data;
}

/// Runs the scenario to its end and tells how the result differs from `before`, in words.
void tellChange(const Scenario& scenario, const GoldenData& before, const Execution& how, bool quiet,
                Findings& f) {
  Progress progress(scenario.scene.name, quiet);
  const auto run = simulate(makeScenarioWorld(scenario, how), recordingOf(scenario, false), progress);
  if (run.signal) throw Interrupted{run.signal};
  const GoldenData now = observe(scenario, run, false);
  f.changed = changedKeys(before, now);
  f.text += changeInWords(before, now);
  if (run.end.status != RunStatus::done)
    f.text += "  the run failed at step " + std::to_string(run.end.steps) + ": " + run.end.failure + "\n";
}

/// A scenario that has changed explains everything else.
bool lookAtInput(const Scenario& scenario, const StoredRun& stored, Findings& f) {
  if (stored.record.scenarioHash == scenario.meaning.text()) return false;
  f.failureClass = f.where.failureClass = "INPUT_CHANGED";
  f.text += "INPUT_CHANGED: the scenario is not that of run " + stored.id + "\n";
  return true;
}

void compareWithStored(const Scenario& scenario, const ExplainOptions& options, const Execution& how,
                       Findings& f) {
  auto store = Store::openForReading(options.database);
  const StoredRun stored = store.find(options.run);
  requireWholeRecord(store, stored);
  const bool otherInput = lookAtInput(scenario, stored, f);
  std::optional<GoldenData> before;
  try {
    before = dataOf(store, stored, storedScenario(options.database, stored.id));
  } catch (const InputError&) {  // stored by a Morula with other keys: the lines still tell
    if (otherInput)
      f.text += "(-: theirs, +: here, all defaults filled in)\n" +
                differingLines(resolvedOf(store.documents(stored.id)), scenario.resolved);
  }
  if (otherInput) {
    if (before) tellChange(scenario, *before, how, options.output.quiet, f);
    return;
  }
  const auto chain = store.chain(stored.id);
  if (chain.empty())
    throw InputError(options.database + ": run " + stored.id +
                     " kept no chain: no hashes of the states on the way; run the scenario again with a golden file or "
                     "with `check: {}` in it, and without --no-check, --set and --seed");
  std::uint64_t step = 0;
  if (const auto broken = findBrokenLink(chain, step); !broken.empty()) {
    f.failureClass = f.where.failureClass = "INPUT_CHANGED";
    f.where.step = step;
    f.text += "INPUT_CHANGED: run " + stored.id + " in " + options.database + ": " + broken + "\n";
    return;
  }
  StoredTrail expected("run " + stored.id + " in " + options.database, chain, stored.steps, stored.failure);
  OwnRun actual = scenarioRun(scenario, how);
  f.where = explain(expected, actual, chain.size() > 1 ? chain[1].step - chain[0].step : 1);
  f.failureClass = f.where.failureClass;
  if (!f.failureClass.empty() && before) tellChange(scenario, *before, how, options.output.quiet, f);
  f.text += f.where.text;
}

void compareWithProgram(const Scenario& scenario, const ExplainOptions& options, const Execution& how,
                        Findings& f) {
  std::vector<std::string> more;
  if (scenario.allowOutside) more.push_back("--allow-outside");  // older programs do not know it
  ProgramRun expected(options.with, scenario.file, [&] { return makeScenarioWorld(scenario, how); }, more);
  OwnRun actual = scenarioRun(scenario, how);
  f.where = explain(expected, actual, strideOf(options));
  f.failureClass = f.where.failureClass;
  f.text += f.where.text;
}

/// Of a golden that cannot be read there is nothing to tell.
std::vector<KeyChange> changedFrom(const Scenario& scenario, const Simulation& run) {
  try {
    return changedKeys(readAccepted(scenario, goldenFile(scenario)).data, observe(scenario, run, false));
  } catch (const InputError&) { return {}; }
}

void compareWithGolden(const Scenario& scenario, const Execution& how, bool quiet, Findings& f) {
  Progress progress(scenario.scene.name, quiet);
  Invariants invariants(scenario.check);
  const auto run = simulate(makeScenarioWorld(scenario, how), recordingOf(scenario, true), progress,
                            [&](const World& world) { invariants.observe(world); });
  if (run.signal) throw Interrupted{run.signal};
  if (run.end.status == RunStatus::failed && checkStop(scenario, run.end.failure).passed()) {
    f.text += describe(checkStop(scenario, run.end.failure));
    return;
  }
  if (run.end.status != RunStatus::done) {
    f.failureClass = "COMPUTATION";
    f.where.step = run.end.steps;
    f.text += "COMPUTATION: the run failed at step " + std::to_string(run.end.steps) + ": " +
              run.end.failure + "\n";
    return;
  }
  const CheckReport report = check(scenario, run, invariants, true);
  f.checks = report.results;
  if (fileExists(goldenFile(scenario)) && !report.passed()) f.changed = changedFrom(scenario, run);
  f.text += describe(report);
  const CheckResult* first = nullptr;  // the one that begins earliest, of the class that explains the others
  for (const auto& r : report.results)
    if (!r.passed && (!first || (first->failureClass == "CHAOS" && r.failureClass != "CHAOS") ||
                      (r.firstStep && first->firstStep && *r.firstStep < *first->firstStep)))
      first = &r;
  if (!first) return;
  f.failureClass = first->failureClass;
  f.where.step = first->firstStep;
  f.where.cell = first->cell;
  if (f.failureClass != "INPUT_CHANGED") {
    f.text +=
        "A golden holds hashes, not states: for the first step, vertex and both values name what it was "
        "accepted "
        "with: --with PROGRAM, or --db FILE\n";
  }
}

Json toJson(const Scenario& scenario, const Findings& f) {
  const auto& d = f.where.difference;
  Json checks = Json::array(), changed = Json::array();
  for (const KeyChange& c : f.changed)
    changed.push_back({{"key", c.key}, {"expected", c.before}, {"actual", c.after}});
  for (const auto& r : f.checks)
    checks.push_back({{"check", r.check},
                      {"passed", r.passed},
                      {"class", r.failureClass},
                      {"first_step", orNull(r.firstStep)}});
  return {{"scenario", goldenName(scenario.file)},
          {"class", f.failureClass},
          {"first_step", orNull(f.where.step)},
          {"last_equal_step", orNull(f.where.lastEqual)},
          {"cell", orNull(f.where.cell)},
          {"cells", f.where.cells},
          {"field", d ? Json(d->field) : Json()},
          {"vertex", d ? orNull(d->vertex) : Json()},
          {"component", d ? Json(d->component) : Json()},
          {"expected", d ? Json(d->expected) : Json()},
          {"actual", d ? Json(d->actual) : Json()},
          {"changed", changed},
          {"text", f.text},
          {"checks", checks}};
}

int act(const ExplainOptions& options) {
  if (!options.with.empty() && !options.database.empty())
    throw UsageError("morula explain: --with or --db, not both");
  if (!options.run.empty() && options.database.empty())
    throw UsageError("morula explain: --run chooses a run of --db FILE");
  const auto how = execution(options.execution);
  const Scenario scenario = loadScenario(options.scenario, {}, options.input.allowOutside);
  Findings f;
  const SignalWatch signals;
  try {
    lookForNondeterminism(scenario, how, strideOf(options), f);
    if (f.failureClass.empty() && !options.database.empty()) compareWithStored(scenario, options, how, f);
    else if (f.failureClass.empty() && !options.with.empty()) compareWithProgram(scenario, options, how, f);
    else if (f.failureClass.empty()) compareWithGolden(scenario, how, options.output.quiet, f);
  } catch (const Interrupted& by) { return signalled + by.signal; }
  if (options.output.json) printJson(toJson(scenario, f));
  else print(f.text);
  return f.failureClass.empty() ? fine : differs;
}

}  // namespace

void addExplain(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExplainOptions>();
  Verb verb(app, action, "explain",
            "Say where and why a result differs: first step, cell, vertex, both values");
  verb.needs("scenario", options->scenario, "FILE", "Scenario file");
  verb.takes("--with", options->with, "PROGRAM",
             "Compare with what this Morula program gives, perhaps an older build");
  verb.takes("--db", options->database, "FILE", "Compare with a stored run");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--every", options->every, "STEPS",
             "Look at every so many steps first; 1 finds also what heals");
  add(verb, options->input);
  add(verb, options->execution);
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

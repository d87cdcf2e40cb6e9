// morula replay: a stored run once more, from its record alone: under which other conditions, and the same
// bits?
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>

#include "base/error.h"
#include "check/check_run.h"
#include "check/sanity.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/verb.h"
#include "files/folders.h"
#include "loop/simulate.h"
#include "loop/stored_scenario.h"
#include "store/provenance.h"
#include "store/store.h"
#include "system/console.h"

namespace morula::cli {

namespace {

struct ReplayOptions {
  std::string what, run, database, databaseOut;
  ExecutionOptions execution{"", "", ""};
  OutputOptions output;
};

/// Which run of which file: `morula replay FILE [--run ID]` or `morula replay ID --db FILE`.
struct Target {
  std::string database, run;
};

Target targetOf(const ReplayOptions& o) {
  if (o.database.empty() && fileExists(o.what)) return {o.what, o.run};
  if (o.database.empty())
    throw UsageError("replay: there is no file '" + o.what +
                     "'; give a database, or a run's id and --db FILE");
  if (!o.run.empty()) throw UsageError("replay: '" + o.what + "' and --run: give one run");
  return {o.database, o.what};
}

/// As the run was executed, as far as this machine can and the command line does not want it otherwise.
Execution executionOf(const ExecutionOptions& options, const RunRecord& before) {
  ExecutionOptions o = options;
  if (o.threads.empty()) o.threads = std::to_string(before.threads);
  Execution how = execution(o);
  if (!options.isa.empty()) return how;
  for (Isa isa : availableIsas())
    if (name(isa) == before.isa) how.isa = isa;
  return how;
}

/// The same run under the conditions of now.
RunRecord recordNow(const RunRecord& before, const Scenario& scenario, const Execution& how,
                    std::vector<Document> documents) {
  RunRecord now;
  now.scenario = before.scenario;
  now.scenarioHash = scenario.meaning.text();
  now.seed = scenario.scene.seed;
  now.documents = std::move(documents);
  now.command = commandLine();
  now.isa = name(how.isa);
  now.threads = how.threads;
  return now;
}

struct Comparison {
  std::vector<Item> conditions;
  std::vector<ValueDifference> record;  // what was changed in the record itself; then nothing was run
  std::string hashBefore, hashNow;      // of the final state, or how it failed
  std::size_t hashesBefore = 0, hashesNow = 0;
  std::optional<std::uint64_t> firstDifference;  // [steps]
  std::vector<TableDifference> tables;
  std::vector<std::string> notCompared;  // which rows, and why

  bool sameBits() const {
    return record.empty() && hashBefore == hashNow && hashesBefore == hashesNow && !firstDifference &&
           std::all_of(tables.begin(), tables.end(), [](const auto& t) { return t.differing == 0; });
  }
};

std::string endText(const std::string& hash, const std::string& failure) {
  return failure.empty() ? hash : "failed: " + failure;
}

void compareEnds(const StoredRun& before, const std::vector<ChainLink>& hashes, const Simulation& run,
                 Comparison& c) {
  c.hashBefore = endText(before.stateHash, before.failure);
  c.hashNow = endText(run.end.stateHash ? run.end.stateHash->text() : "", run.end.failure);
  c.hashesBefore = hashes.size();
  c.hashesNow = run.results.chain.size();
  const auto [a, b] =
      std::mismatch(hashes.begin(), hashes.end(), run.results.chain.begin(), run.results.chain.end());
  if (a != hashes.end()) c.firstDifference = a->step;
  else if (b != run.results.chain.end()) c.firstDifference = b->step;
}

/// Drops a table in which the two cannot be expected to agree, and says why.
void leaveOut(Comparison& c, const std::string& table, const std::string& why) {
  const auto found = std::find_if(c.tables.begin(), c.tables.end(),
                                  [&](const TableDifference& t) { return t.table == table; });
  if (found == c.tables.end()) return;
  c.tables.erase(found);
  c.notCompared.push_back(table + ": " + why);
}

/// What the file holds of the run, beside what the run gave now.
void compareTables(Store& stored, const StoredRun& before, Store& again, const RunRecord& now, bool checked,
                   Comparison& c) {
  c.tables = stored.compareResults(before.id, again, runId(now));
  const bool sameProgram = buildId(before.record.build) == buildId(now.build);
  std::vector<std::string> later;
  for (const TableDifference& t : c.tables)
    if (!sameProgram && t.rows == 0 && t.recomputedRows > 0) later.push_back(t.table);
  for (const std::string& table : later) leaveOut(c, table, "another program stored none");
  std::size_t elsewhere = 0;
  for (const CheckResult& r : stored.checks(before.id)) elsewhere += r.kind == "golden" || r.kind == "bullet";
  if (!checked) leaveOut(c, "check_result", "the run was not checked");
  if (elsewhere > 0)
    c.notCompared.push_back(fmt::format(
        "check_result: {} of kind golden or bullet, which hang on what is not stored", elsewhere));
  for (const TableContents& t : stored.contents(before.id))
    if (t.table == "bullet_sample" && t.rows > 0)
      c.notCompared.push_back("bullet_sample: Bullet is not run again");
}

std::string describe(const ValueDifference& d) {
  if (d.column.empty()) return fmt::format("{}: stored: {}; recomputed: {}", d.row, d.stored, d.recomputed);
  return fmt::format("{}: {}: stored {}, recomputed {}", d.row, d.column, d.stored, d.recomputed);
}

std::string describeTables(const Comparison& c) {
  std::string text;
  std::size_t same = 0;
  std::uint64_t rows = 0;
  for (const TableDifference& t : c.tables) {
    if (t.differing == 0) ++same, rows += t.rows;
    else
      text += fmt::format("  {:<15} {} of {} rows differ{}\n    first {}\n", t.table, t.differing,
                          std::max(t.rows, t.recomputedRows),
                          t.rows == t.recomputedRows
                              ? ""
                              : fmt::format(" ({} are stored, {} recomputed)", t.rows, t.recomputedRows),
                          describe(*t.first));
  }
  text += fmt::format("  tables          {}{} the same, {} rows\n", same == c.tables.size() ? "all " : "",
                      same, rows);
  for (const std::string& what : c.notCompared) text += fmt::format("  not compared    {}\n", what);
  return text;
}

std::string describe(const Comparison& c, const StoredRun& run) {
  auto text = fmt::format("{}  seed {}: run {}, replayed\n", run.record.scenario, run.record.seed, run.id);
  if (!c.record.empty()) {
    text = fmt::format("{}  seed {}: run {}, not replayed: its record was changed since it was stored\n",
                       run.record.scenario, run.record.seed, run.id);
    for (const ValueDifference& d : c.record) text += fmt::format("  {:<15} {}\n", d.table, describe(d));
    return text + "NOT the same record\n";
  }
  std::size_t same = 0;
  for (const auto& [item, before, now] : c.conditions) {
    if (before == now) ++same;
    else text += fmt::format("  {:<15} differs\n    then  {}\n    now   {}\n", item, before, now);
  }
  text += same == c.conditions.size() ? fmt::format("  conditions      all {} the same\n", same)
                                      : fmt::format("  conditions      {} others the same\n", same);
  if (c.hashBefore == c.hashNow) text += fmt::format("  state           the same: {}\n", c.hashNow);
  else
    text += fmt::format("  state           differs\n    then  {}\n    now   {}\n", c.hashBefore, c.hashNow);
  if (c.firstDifference)
    text += fmt::format("  steps           differ first at step {}\n", *c.firstDifference);
  else if (c.hashesBefore > 0)
    text += fmt::format("  steps           all {} hashes on the way the same\n", c.hashesBefore);
  else text += "  steps           none were hashed on the way\n";
  return text + describeTables(c) + (c.sameBits() ? "the same bits\n" : "NOT the same bits\n");
}

Json toJson(const ValueDifference& d) {
  return {{"table", d.table},
          {"row", d.row},
          {"column", d.column},
          {"stored", d.stored},
          {"recomputed", d.recomputed}};
}

Json toJson(const Comparison& c, const StoredRun& run) {
  Json conditions = Json::array(), tables = Json::array(), record = Json::array();
  for (const auto& [item, before, now] : c.conditions)
    conditions.push_back({{"item", item}, {"then", before}, {"now", now}, {"same", before == now}});
  for (const TableDifference& t : c.tables)
    tables.push_back({{"table", t.table},
                      {"stored", t.rows},
                      {"recomputed", t.recomputedRows},
                      {"differing", t.differing},
                      {"first", t.first ? toJson(*t.first) : Json()}});
  for (const ValueDifference& d : c.record) record.push_back(toJson(d));
  return {{"run_id", run.id},
          {"scenario", run.record.scenario},
          {"seed", run.record.seed},
          {"same_bits", c.sameBits()},
          {"state_hash", {{"then", c.hashBefore}, {"now", c.hashNow}, {"same", c.hashBefore == c.hashNow}}},
          {"step_hashes",
           {{"then", c.hashesBefore}, {"now", c.hashesNow}, {"first_difference", orNull(c.firstDifference)}}},
          {"record", record},
          {"tables", tables},
          {"not_compared", c.notCompared},
          {"conditions", conditions}};
}

int report(const Comparison& c, const StoredRun& run, const OutputOptions& output) {
  if (output.json) printJson(toJson(c, run));
  else print(describe(c, run));
  return c.sameBits() ? fine : differs;
}

/// The kinds of checks that the run was held against and that it decides itself: it is again.
std::set<std::string> kindsOfChecks(Store& store, const std::string& id) {
  std::set<std::string> kinds;
  for (const CheckResult& r : store.checks(id))
    if (r.kind != "golden" && r.kind != "bullet") kinds.insert(r.kind);
  return kinds;
}

int act(const ReplayOptions& options) {
  const Target target = targetOf(options);
  auto store = Store::openForReading(target.database);
  const StoredRun before = store.find(target.run);
  if (before.status != RunStatus::done && before.status != RunStatus::failed)
    throw UsageError("replay: run " + before.id + " has not ended (" + name(before.status) +
                     "); morula run --resume goes on with it");
  Comparison c;
  c.record = store.changedRecord(before.id);
  if (!c.record.empty()) return report(c, before, options.output);
  const Scenario scenario = storedScenario(target.database, before.id);
  const Execution how = executionOf(options.execution, before.record);
  const RunRecord now = recordNow(before.record, scenario, how, store.documents(before.id));
  c.conditions = compareConditions(before.record, now);
  const std::vector<ChainLink> hashes = store.chain(before.id);

  Progress progress(before.record.scenario, options.output.quiet);
  const auto kinds = kindsOfChecks(store, before.id);
  Invariants invariants(kinds.contains("invariant") ? scenario.check : CheckParameters{});
  World world = makeScenarioWorld(scenario, how);
  const SanityCheck sanity(world);
  auto run = simulate(std::move(world), recordingOf(scenario, !hashes.empty()), progress,
                      Invariants::areGiven(scenario.check) && kinds.contains("invariant")
                          ? [&](const World& w) { invariants.observe(w); }
                          : std::function<void(const World&)>());
  if (run.signal) return signalled + run.signal;
  run.results.checks = checkWithoutGolden(scenario, run, invariants);
  if (kinds.contains("sanity") && run.end.status == RunStatus::done)
    for (auto& result : sanity.results(run.world, scenario.check, kinds.contains("invariant")))
      run.results.checks.push_back(std::move(result));
  std::erase_if(run.results.checks, [&](const CheckResult& r) { return !kinds.contains(r.kind); });
  compareEnds(before, hashes, run, c);
  auto again = Store::temporary();
  again.finish(again.begin(now), run.end, run.results);
  compareTables(store, before, again, now, !kinds.empty(), c);
  if (!options.databaseOut.empty()) {
    auto out = Store::openForWriting(options.databaseOut);
    out.finish(out.begin(now), run.end, run.results);
  }
  return report(c, before, options.output);
}

}  // namespace

void addReplay(CLI::App& app, Action& action) {
  auto options = std::make_shared<ReplayOptions>();
  Verb verb(app, action, "replay", "Run a stored run again and say what differs, conditions and bits");
  verb.needs("what", options->what, "FILE|ID", "A database, or a run's id with --db");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--db", options->database, "FILE", "The database, if a run's id is given");
  verb.takes("--db-out", options->databaseOut, "FILE", "Store the replayed run there; default: nowhere");
  add(verb, options->execution);
  verb.showDefault("--threads", "as then");
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

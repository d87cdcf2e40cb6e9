// morula replay: a stored run once more, from its record alone: under which other conditions, and the same
// bits?
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "cli/console.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/provenance.h"
#include "cli/simulate.h"
#include "cli/stored.h"
#include "cli/verb.h"
#include "store/store.h"

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
  if (o.database.empty() && std::filesystem::exists(o.what)) return {o.what, o.run};
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
  std::string hashBefore, hashNow;  // of the final state, or how it failed
  std::size_t hashesBefore = 0, hashesNow = 0;
  std::optional<std::uint64_t> firstDifference;  // [steps]

  bool sameBits() const { return hashBefore == hashNow && hashesBefore == hashesNow && !firstDifference; }
};

std::string endText(const std::string& hash, const std::string& failure) {
  return failure.empty() ? hash : "failed: " + failure;
}

Comparison compare(const StoredRun& before, const std::vector<ChainLink>& hashes, const Simulation& run,
                   const RunRecord& now) {
  Comparison c;
  c.conditions = compareConditions(before.record, now);
  c.hashBefore = endText(before.stateHash, before.failure);
  c.hashNow = endText(run.end.stateHash ? run.end.stateHash->text() : "", run.end.failure);
  c.hashesBefore = hashes.size();
  c.hashesNow = run.results.chain.size();
  const auto [a, b] =
      std::mismatch(hashes.begin(), hashes.end(), run.results.chain.begin(), run.results.chain.end());
  if (a != hashes.end()) c.firstDifference = a->step;
  else if (b != run.results.chain.end()) c.firstDifference = b->step;
  return c;
}

std::string describe(const Comparison& c, const StoredRun& run) {
  auto text = fmt::format("{}  seed {}: run {}, replayed\n", run.record.scenario, run.record.seed, run.id);
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
  return text + (c.sameBits() ? "the same bits\n" : "NOT the same bits\n");
}

Json toJson(const Comparison& c, const StoredRun& run) {
  Json conditions = Json::array();
  for (const auto& [item, before, now] : c.conditions)
    conditions.push_back({{"item", item}, {"then", before}, {"now", now}, {"same", before == now}});
  return {{"run_id", run.id},
          {"scenario", run.record.scenario},
          {"seed", run.record.seed},
          {"same_bits", c.sameBits()},
          {"state_hash", {{"then", c.hashBefore}, {"now", c.hashNow}, {"same", c.hashBefore == c.hashNow}}},
          {"step_hashes",
           {{"then", c.hashesBefore}, {"now", c.hashesNow}, {"first_difference", orNull(c.firstDifference)}}},
          {"conditions", conditions}};
}

int act(const ReplayOptions& options) {
  const Target target = targetOf(options);
  auto store = Store::openForReading(target.database);
  const StoredRun before = store.find(target.run);
  if (before.status != RunStatus::done && before.status != RunStatus::failed)
    throw UsageError("replay: run " + before.id + " has not ended (" + name(before.status) +
                     "); morula run --resume goes on with it");
  const Scenario scenario = storedScenario(target.database, before.id);
  const Execution how = executionOf(options.execution, before.record);
  const RunRecord now = recordNow(before.record, scenario, how, store.documents(before.id));
  const std::vector<ChainLink> hashes = store.chain(before.id);

  Progress progress(before.record.scenario, options.output.quiet);
  const auto run =
      simulate(makeScenarioWorld(scenario, how), recordingOf(scenario, !hashes.empty()), progress);
  if (run.signal) return signalled + run.signal;
  const Comparison c = compare(before, hashes, run, now);
  if (options.output.json) printJson(toJson(c, before));
  else print(describe(c, before));
  if (!options.databaseOut.empty()) {
    auto out = Store::openForWriting(options.databaseOut);
    out.finish(out.begin(now), run.end, run.results);
  }
  return c.sameBits() ? fine : differs;
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

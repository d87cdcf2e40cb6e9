// morula replay: runs a stored run again from its record alone, also under other conditions, and compares all bits.
#include "check/replay.h"

#include "base/error.h"
#include "cli/verbs.h"
#include "files/folders.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/program.h"
#include "options/verb.h"
#include "system/console.h"

namespace morula::cli {
namespace {

struct ReplayOptions {
  std::string what, run, database, databaseOut;
  ExecutionOptions execution{.threads = std::nullopt};  // default: the stored number
  OutputOptions output;
};

/// A run and its file: `morula replay FILE [--run ID]` or `morula replay ID --db FILE`.
struct Target {
  std::string database, run;
};

Target targetOf(const ReplayOptions& o) {
  if (o.database.empty() && fileExists(o.what)) return {o.what, o.run};
  if (o.database.empty())
    throw UsageError("replay: there is no file '" + o.what + "'; give a database, or a run's id and --db FILE");
  if (!o.run.empty()) throw UsageError("replay: '" + o.what + "' and --run name a run each; give one of them");
  return {o.database, o.what};
}

/// Returns the execution of the stored run, as far as this machine can and the command line does not change it.
Execution executionOf(const ExecutionOptions& options, const RunRecord& before) {
  Execution how = execution(options);
  if (!options.threads) how.threads = before.threads;
  if (options.isa) return how;
  for (Isa isa : availableIsas())
    if (name(isa) == before.isa) how.isa = isa;
  return how;
}

int report(const Replay& found, const StoredRun& run, const OutputOptions& output) {
  printEither(output, toJson(found, run), describe(found, run));
  return found.sameBits() ? fine : differs;
}

int act(const ReplayOptions& options) {
  const Target target = targetOf(options);
  if (!options.databaseOut.empty() && liesWithin(options.databaseOut, target.database))
    throw UsageError("--db-out: '" + options.databaseOut +
                     "' holds the run that is replayed, and would be written over; needs another file");
  auto store = Store::openForReading(target.database);
  if (!options.databaseOut.empty() && sameFile(options.databaseOut, target.database))
    throw UsageError("--db-out: '" + options.databaseOut + "' holds the run that is replayed; give another file");
  const StoredRun before = store.find(target.run);
  if (before.status != RunStatus::done && before.status != RunStatus::failed)
    throw UsageError("replay: run " + before.id + " has not ended (" + name(before.status) +
                     "); continue it with morula run --resume");
  Replay found;
  found.record = store.changedRecord(before.id);
  if (!found.record.empty()) return report(found, before, options.output);
  found = replay(store, before, storedScenario(target.database, before.id),
                 {.execution = executionOf(options.execution, before.record),
                  .command = commandLine(),
                  .databaseOut = options.databaseOut,
                  .quiet = options.output.quiet});
  if (found.sameBits()) store.requireIntact(before.id);  // columns that no run computes may have been changed, too
  return report(found, before, options.output);
}

}  // namespace

void addReplay(CLI::App& app, Action& action) {
  Verb verb(app, action, "replay", "Run a stored run again and list differences of its conditions and its bits");
  auto& options = verb.does<ReplayOptions>(act);
  verb.needs("what", options.what, "FILE|ID", "A database, or a run's id with --db");
  addRunChoice(verb, options.run);
  verb.takes("--db", options.database, "FILE", "The database, if a run's id is given");
  verb.takes("--db-out", options.databaseOut, "FILE",
             "Store the replayed run in this file; default: the run is not "
             "stored");
  add(verb, options.execution);
  verb.showDefault("--threads", "as then");
  add(verb, options.output);
}

}  // namespace morula::cli

// morula export: a stored run for others, as a folder that describes itself; without one, which runs there
// are.
#include <fmt/format.h>

#include <memory>

#include "base/error.h"
#include "cli/exit_codes.h"
#include "cli/options.h"
#include "cli/verb.h"
#include "export/license.h"
#include "export/run_crate.h"
#include "loop/stored_scenario.h"
#include "system/console.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

struct ExportOptions {
  std::string database, run, crate, pictures, agent, license;
  bool list = false;
  OutputOptions output;
};

int listRuns(Store& store, const ExportOptions& options) {
  Json list = Json::array();
  for (const StoredRun& run : store.runs()) {
    if (!options.output.json)
      print(fmt::format("{}  {}  {}  {}  seed {}\n", run.id, run.started, name(run.status),
                        run.record.scenario, run.record.seed));
    list.push_back({{"run_id", run.id},
                    {"scenario", run.record.scenario},
                    {"seed", run.record.seed},
                    {"status", name(run.status)},
                    {"started", run.started},
                    {"state_hash", run.stateHash.empty() ? Json() : Json(run.stateHash)}});
  }
  if (options.output.json) printJson({{"runs", list}});
  return fine;
}

/// What the file consists of. Of one run only if it is named.
int listTables(Store& store, const ExportOptions& options) {
  const std::string id = options.run.empty() ? "" : store.find(options.run).id;
  Json list = Json::array();
  std::uint64_t rows = 0, bytes = 0;
  for (const TableContents& t : store.contents(id)) {
    rows += t.rows, bytes += t.bytes;
    if (!options.output.json)
      print(fmt::format("{:<16} {:>9} row{} {}{:>10} B  {}\n", t.table, t.rows, t.rows == 1 ? " " : "s",
                        t.estimated ? "~" : " ", t.bytes, t.why));
    list.push_back({{"table", t.table},
                    {"rows", t.rows},
                    {"bytes", t.bytes},
                    {"bytes_estimated", t.estimated},
                    {"why", t.why}});
  }
  if (options.output.json)
    printJson({{"file", options.database}, {"run_id", id.empty() ? Json() : Json(id)}, {"tables", list}});
  else print(fmt::format("{:<16} {:>9} rows  {:>10} B\n", "all", rows, bytes));
  return fine;
}

int act(const ExportOptions& options) {
  auto store = Store::openForReading(options.database);
  if (options.list && !options.crate.empty()) throw UsageError("export: --list or --ro-crate, not both");
  if (options.crate.empty()) {
    if (options.list && options.pictures.empty() && options.agent.empty() && options.license.empty())
      return listTables(store, options);
    if (!options.run.empty() || !options.pictures.empty() || !options.agent.empty() ||
        !options.license.empty())
      throw UsageError("export: --ro-crate FOLDER says what to make of the run");
    return listRuns(store, options);
  }
  const StoredRun run = store.find(options.run);
  const std::string license = licenseUri(options.license);
  requireWholeRecord(store, run);
  const fs::path folder = options.crate;
  CrateRun crate = crateOf(store, run, options.pictures, folder);
  crate.agent = options.agent, crate.license = license;
  writeCrate(crate, folder);
  if (options.output.json)
    printJson({{"run_id", crate.run.id}, {"crate", folder.string()}, {"files", crate.files.size()}});
  else print(fmt::format("{} ({} files and ro-crate-metadata.json)\n", folder.string(), crate.files.size()));
  return fine;
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
  auto options = std::make_shared<ExportOptions>();
  Verb verb(app, action, "export", "List the runs of a database, or give one to others as a folder");
  verb.needs("file", options->database, "FILE", "A database");
  verb.takes("--run", options->run, "ID", "Which run of the database; default: the latest");
  verb.takes("--list", options->list,
             "List the tables: rows, bytes, who reads them; of all runs, or of --run alone");
  verb.takes("--ro-crate", options->crate, "FOLDER", "Write a Process Run Crate (RO-Crate 1.1) there");
  verb.takes("--pictures", options->pictures, "FOLDER",
             "Where the run's pictures lie; default: beside a database of one run");
  verb.takes("--agent", options->agent, "WHO", "Who ran it: a name, or a URI such as an ORCID");
  verb.takes("--license", options->license, "LICENCE",
             "The results' licence: an SPDX identifier, as CC-BY-4.0, or a URI");
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

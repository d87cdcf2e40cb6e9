// morula export: stored runs for others, as tables, trees, surfaces or a folder that describes itself; without one,
// which runs there are.
#include <fmt/format.h>

#include <memory>

#include "base/error.h"
#include "cli/verbs.h"
#include "export/formats.h"
#include "export/license.h"
#include "export/run_crate.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "study_store/study_tables.h"
#include "system/console.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

struct ExportOptions {
  std::string database, run, crate, pictures, agent, license;
  std::string format, path, time, table;
  bool list = false;
  ExecutionOptions execution;
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
  for (const TableContents& t : store.contents(allTables(), id)) {
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

/// What belongs to a format alone.
void requireNoFormatOptions(const ExportOptions& options) {
  for (const auto& [name, word] :
       {std::pair("--output", options.path), {"--time", options.time}, {"--table", options.table}})
    if (!word.empty()) throw UsageError(std::string(name) + ": only with --format");
}

int writeFormat(const ExportOptions& options) {
  if (options.list || !options.crate.empty())
    throw UsageError("export: only one of --format, --ro-crate and --list");
  if (!options.pictures.empty() || !options.agent.empty() || !options.license.empty())
    throw UsageError("export: --pictures, --agent and --license belong to --ro-crate");
  ExportRequest request;
  request.format = formatCalled(options.format);
  if (options.path.empty()) throw UsageError("--format: needs -o PATH, where to write");
  request.output = options.path, request.run = options.run, request.table = options.table;
  if (!options.time.empty()) request.time = nonNegativeOption("--time", options.time);
  request.execution = execution(options.execution);
  request.quiet = options.output.quiet;
  auto store = Store::openForReading(options.database);
  const Exported exported = exportRuns(store, request);
  if (exported.signal) return signalled + exported.signal;
  Json runs = Json::array();
  for (const ExportedFiles& run : exported.runs) {
    Json files = Json::array();
    for (const fs::path& file : run.files) {
      files.push_back(file.string());
      if (!options.output.json) print(file.string() + "\n");
    }
    runs.push_back({{"run_id", run.run.empty() ? Json() : Json(run.run)}, {"files", files}});
  }
  if (options.output.json) printJson({{"format", request.format}, {"runs", runs}});
  return fine;
}

int act(const ExportOptions& options) {
  if (!options.format.empty()) return writeFormat(options);
  requireNoFormatOptions(options);
  auto store = Store::openForReading(options.database);
  if (options.list && !options.crate.empty()) throw UsageError("export: --list or --ro-crate, not both");
  if (options.crate.empty()) {
    if (options.list && options.pictures.empty() && options.agent.empty() && options.license.empty())
      return listTables(store, options);
    if (!options.run.empty() || !options.pictures.empty() || !options.agent.empty() ||
        !options.license.empty())
      throw UsageError("export: --format or --ro-crate says what to make of the run");
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
  Verb verb(
      app, action, "export",
      "List the runs of a database, or give them to others: as tables, trees, surfaces, arrays or a folder");
  verb.needs("file", options->database, "FILE", "A database");
  verb.takes("--run", options->run, "ID",
             "Which run of the database; default: the latest, and with --format all");
  verb.takes("--format", options->format, "NAME", formatList());
  verb.takes(
      "-o,--output", options->path, "PATH",
      "With --format: the file or folder, which must be new; of several runs a folder with one for each");
  verb.takes("--time", options->time, "TIME", "With surfaces: of this time alone");
  verb.takes("--table", options->table, "NAME", "With --format csv: only this one, as cells or samples");
  verb.takes("--list", options->list,
             "List the tables: rows, bytes, who reads them; of all runs, or of --run alone");
  verb.takes("--ro-crate", options->crate, "FOLDER", "Write a Process Run Crate (RO-Crate 1.1) there");
  verb.takes("--pictures", options->pictures, "FOLDER",
             "Where the run's pictures lie; default: beside a database of one run");
  verb.takes("--agent", options->agent, "WHO", "Who ran it: a name, or a URI such as an ORCID");
  verb.takes("--license", options->license, "LICENCE",
             "The results' licence: an SPDX identifier, as CC-BY-4.0, or a URI");
  add(verb, options->execution);
  add(verb, options->output);
  verb.does([options] { return act(*options); });
}

}  // namespace morula::cli

// morula export: stored runs for other programs, as tables, trees, surfaces or a folder that describes itself.
// Without any of these, lists the runs.
#include <fmt/format.h>

#include "base/error.h"
#include "cli/verbs.h"
#include "document/table.h"
#include "export/formats.h"
#include "export/ro_crate.h"
#include "export/run_crate.h"
#include "files/scratch_folder.h"
#include "files/text.h"
#include "loop/stored_scenario.h"
#include "options/exit_codes.h"
#include "options/options.h"
#include "options/verb.h"
#include "report/study_part.h"
#include "study_store/study_tables.h"
#include "system/console.h"
#include "system/installation.h"
#include "system/usage_error.h"

namespace morula::cli {

namespace fs = std::filesystem;

namespace {

struct ExportOptions {
  std::string database, path, crate, pictures, agent, license;
  ExportRequest request;
  bool list = false;
  ExecutionOptions execution;
  OutputOptions output;
};

int listRuns(Store& store, const ExportOptions& options) {
  using Row = StoredRun;
  static const std::vector<FieldOf<Row>> fields{
      {{"run_id", "", "run"}, [](const Row& run) { return run.id; }},
      {{"scenario", "", "scenario"}, [](const Row& run) { return run.record.scenario; }},
      {{"seed", "", "seed"}, [](const Row& run) { return run.record.seed; }},
      {{"status", "", "status"}, [](const Row& run) { return name(run.status); }},
      {{"started", "", "started"}, [](const Row& run) { return run.started; }},
      {{"state_hash", "", ""},
       [](const Row& run) { return exact(run.stateHash.empty() ? Json() : Json(run.stateHash)); }},
  };
  const Table runs = tableOf("Runs", fields, store.runs());
  printEither(options.output, {{"runs", jsonOf(runs)}}, textOf(runs));
  return fine;
}

/// Lists the tables of the file, or of one run if it is named.
int listTables(Store& store, const ExportOptions& options) {
  using Row = TableContents;
  static const std::vector<FieldOf<Row>> fields{
      {{"table", "", "table"}, [](const Row& t) { return t.table; }},
      {{"rows", "", "rows"}, [](const Row& t) { return t.rows; }},
      {{"bytes", "", "bytes"},
       [](const Row& t) { return Cell(t.bytes, (t.estimated ? "~" : "") + std::to_string(t.bytes)); }},
      {{"bytes_estimated", "", ""}, [](const Row& t) { return exact(t.estimated); }},
      {{"why", "", "stored"}, [](const Row& t) { return t.why; }},
  };
  const std::string id = options.request.run.empty() ? "" : store.find(options.request.run).id;
  const auto contents = store.contents(allTables(), id);
  std::uint64_t rows = 0, bytes = 0;
  for (const TableContents& t : contents) rows += t.rows, bytes += t.bytes;
  const Table tables = tableOf("Tables", fields, contents);
  printEither(options.output,
              {{"file", options.database}, {"run_id", id.empty() ? Json() : Json(id)}, {"tables", jsonOf(tables)}},
              textOf(tables) + fmt::format("  all: {} rows, {} bytes\n", rows, bytes));
  return fine;
}

int writeFormat(const ExportOptions& options) {
  ExportRequest request = options.request;
  if (options.path.empty()) throw UsageError("--format: needs -o PATH, the file or folder to write");
  request.output = options.path;
  request.execution = execution(options.execution);
  request.quiet = options.output.quiet;
  auto store = Store::openForReading(options.database);
  const Exported exported = exportRuns(store, request);
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
  if (!options.request.format.empty()) return writeFormat(options);
  auto store = Store::openForReading(options.database);
  if (options.list) return listTables(store, options);
  if (options.crate.empty()) return listRuns(store, options);
  if (options.request.run.empty() && isMergedStudy(options.database))
    throw UsageError("--ro-crate: " + options.database + " holds " + std::to_string(store.runs().size()) +
                     " runs of a study, and a crate holds one run; choose it by --run ID (`" + programWord() +
                     " export " + shellWord(options.database) + "` lists them), or export the whole study by `" +
                     programWord() + " study export " + shellWord(options.database) + "`");
  const StoredRun run = store.find(options.request.run);
  requireWholeRecord(store, run);
  tellUnlessFine(store, run);
  const fs::path folder = options.crate;
  DraftFolder draft(folder);
  Crate crate = crateOf(store, run, options.pictures, draft.path());
  crate.agent = options.agent, crate.license = options.license;
  writeCrate(crate, draft.path());
  draft.takePlace();
  if (options.license.empty()) tell(noLicence, options.output.quiet);
  printEither(options.output, {{"run_id", run.id}, {"crate", folder.string()}, {"files", crate.files.size()}},
              fmt::format("{} ({} files and ro-crate-metadata.json)\n", folder.string(), crate.files.size()));
  return fine;
}

}  // namespace

void addExport(CLI::App& app, Action& action) {
  Verb verb(app, action, "export",
            "List the runs of a database, or export them as tables, trees, surfaces, arrays or a crate");
  auto& options = verb.does<ExportOptions>(act);
  verb.needs("file", options.database, "FILE", "A database");
  verb.takes("--run", options.request.run, "ID",
             "Run of the database, by its id; default: the latest, or all runs with --format");
  verb.takes("--format", options.request.format, "NAME", formatCalled, formatList());
  verb.takes("-o,--output", options.path, "PATH",
             "With --format: a new file or folder; for several runs a folder with one for each");
  verb.takes("--time", options.request.time, "TIME", number(scenario::notNegative),
             "Export only the surfaces of this time");
  verb.takes("--table", options.request.table, "NAME",
             "With --format csv: export only this table, as cells or "
             "samples");
  verb.takes("--no-comments", options.request.noComments,
             "With --format newick: leave out path, fate and state ([&&NHX...]), which some programs cannot read");
  verb.takes("--no-surfaces", options.request.noSurfaces,
             "With --format npz: leave out surfaces, for which the run may have to be simulated again");
  verb.takes("--list", options.list,
             "List the tables with their rows, bytes and readers; of all runs, or of --run "
             "alone");
  verb.takes("--ro-crate", options.crate, "FOLDER", "Folder for a Process Run Crate (RO-Crate 1.1)");
  verb.takes("--pictures", options.pictures, "FOLDER",
             "Folder of the run's pictures for --ro-crate; default: beside a database of one run");
  verb.takes("--agent", options.agent, "WHO", "Person who ran the simulation: a name, or a URI such as an ORCID");
  verb.takes("--license", options.license, "LICENCE", licenseUri,
             "The results' licence: an SPDX identifier, as CC-BY-4.0, or a URI");
  verb.oneOf({"--format", "--ro-crate", "--list"});
  verb.onlyWith({"--output", "--time", "--table", "--no-comments", "--no-surfaces"}, {"--format"});
  verb.onlyWith({"--pictures", "--agent", "--license"}, {"--ro-crate"});
  verb.onlyWith({"--run"}, {"--format", "--ro-crate", "--list"});
  add(verb, options.execution);
  add(verb, options.output);
}

}  // namespace morula::cli

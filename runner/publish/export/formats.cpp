#include "export/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "analysis/organisms.h"
#include "analysis/study_results.h"
#include "base/did_you_mean.h"
#include "base/error.h"
#include "export/csv.h"
#include "export/geff.h"
#include "export/gltf.h"
#include "export/newick.h"
#include "export/npz.h"
#include "export/ply.h"
#include "export/surfaces.h"
#include "export/tracks.h"
#include "export/vtk.h"
#include "files/folders.h"
#include "files/scratch_folder.h"
#include "files/text.h"
#include "files/write_file.h"
#include "loop/stored_scenario.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {

namespace fs = std::filesystem;

namespace {

/// Returns a row for each cell that ever lived, by path.
CsvTable cellTable(const ExportedRun& run) {
  CsvTable csv({{"cell", "number of the cell in the other files, from 0"},
                {"path", "lineage path: egg, or A and B for each division"},
                {"name", "name of the cell, or else its path"},
                {"born", "", "time"},
                {"ended", "empty while alive", "time"},
                {"fate", "divided, died or alive"},
                {"state", "number of its last state in states"}});
  std::int64_t number = 0;
  for (const LineageEntry& cell : run.results.lineage) {
    const TableValue ended = cell.fate == Fate::alive ? TableValue() : cell.ended;
    csv.add({number++, csvPath(cell.path.text()), run.nameOf(cell), cell.born, ended, name(cell.fate),
             std::int64_t{run.stateNumber(cell.state)}});
  }
  return csv;
}

/// Returns a row for each state.
CsvTable stateTable(const ExportedRun& run) {
  CsvTable csv({{"state", "number of the state in the other files, from 0"},
                {"substances", "sorted, separated by blanks"},
                {"colour", "#rrggbb, of cells in this state"}});
  for (std::size_t i = 0; i < run.states.size(); ++i) {
    Colour colour = neutralGrey;
    for (const auto& [state, text] : run.results.stateTexts)
      if (text == run.states[i]) colour = run.colours.at(state);
    csv.add({static_cast<std::int64_t>(i), run.states[i],
             fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b)});
  }
  return csv;
}

struct NewFile {
  fs::path path;
  std::string bytes;
};
using Files = std::vector<NewFile>;
using OneTime = std::string (*)(const ExportedRun&, const Sample&);

/// Adds tables to the folder, and the description of their columns.
void addTables(const std::vector<NamedTable>& tables, const fs::path& folder, const Units& units, Files& files) {
  Json columns = Json::object();
  for (const auto& [name, table] : tables) {
    files.push_back({folder / (name + ".csv"), table.text()});
    columns[name] = table.columns(units);
  }
  files.push_back({folder / "columns.json", jsonText(columns, 2) + "\n"});
}

/// Returns one table, and the description of its columns beside it.
Files oneTable(const CsvTable& table, const fs::path& path, const Units& units) {
  fs::path columns = path;
  columns.replace_extension(".columns.json");
  return {{path, table.text()}, {columns, jsonText(table.columns(units), 2) + "\n"}};
}

/// Returns a file for each sample, in the folder `path`, and a table of their times.
Files series(const ExportedRun& run, const fs::path& path, const char* ending, OneTime write) {
  Files files;
  CsvTable times({{"file", "name of the file"}, {"time", "of its surfaces", "time"}});
  for (const Sample& sample : run.results.samples) {
    const std::string name = fmt::format("{:04}{}", files.size(), ending);
    times.add({name, sample.world.time});
    files.push_back({path / name, write(run, sample)});
  }
  addTables({{"times", times}, {"cells", cellTable(run)}, {"states", stateTable(run)}}, path, run.units, files);
  return files;
}

Files vtkFiles(const ExportedRun& run, const fs::path& path) {
  Files files;
  std::vector<std::string> names;
  for (const Sample& sample : run.results.samples) {
    names.push_back(fmt::format("surfaces_{:04}.vtp", names.size()));
    files.push_back({path / names.back(), vtpFile(run, sample)});
  }
  addTables({{"cells", cellTable(run)}, {"states", stateTable(run)}}, path, run.units, files);
  files.push_back({path / "surfaces.pvd", pvdFile(run, names)});
  return files;
}

Files oneOrSeries(const ExportedRun& run, const fs::path& path, const char* ending, OneTime write) {
  if (path.extension() != ending) return series(run, path, ending, write);
  return {{path, write(run, run.results.samples.back())}};
}

/// A format with separate files for each run.
struct Format {
  const char* name;
  const char* what;
  const char* ending;  // ending of its file; "": a folder
  Wanted wanted;
  bool mayBeSeries;  // true: a name without the ending is a folder with a file for each time
  Files (*files)(const ExportedRun&, const fs::path&, const ExportRequest&);
};

constexpr const char* csv = "csv";
const Format formats[] = {
    {"tracks", "places of cells over time, with names and mothers, as init --from reads them (.csv)", ".csv",
     Wanted::measures, false,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest& request) {
       return oneTable(trackTable(tracksOf(run, request.quiet)), path, {});  // numbers are in the known units
     }},
    {"geff", "the same as a graph for tracking tools (GEFF on Zarr 2), a folder", "", Wanted::measures, false,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest& request) {
       Files files;
       const ZarrFolder graph = geffGraph(run, tracksOf(run, request.quiet));
       for (const auto& [name, bytes] : graph.files()) files.push_back({path / name, bytes});
       return files;
     }},
    {"newick", "the tree of cells, with branch lengths", ".nwk", Wanted::tree, false,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest& request) {
       return Files{{path, newickTree(run, !request.noComments)}};
     }},
    {"vtk", "surfaces over time with fields (.vtp and .pvd, for ParaView), a folder", "", Wanted::surfaces, false,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest&) { return vtkFiles(run, path); }},
    {"ply", "surfaces of one time (FILE.ply), or a folder with a file a time", ".ply", Wanted::surfaces, true,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest&) {
       return oneOrSeries(run, path, ".ply", plyFile);
     }},
    {"gltf", "surfaces of one time (FILE.glb), or a folder with a file a time", ".glb", Wanted::surfaces, true,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest&) {
       return oneOrSeries(run, path, ".glb", glbFile);
     }},
    {"npz", "cells, samples, contacts and surfaces as arrays for NumPy", ".npz", Wanted::samples, false,
     [](const ExportedRun& run, const fs::path& path, const ExportRequest&) {
       return Files{{path, npzFile(run)}};
     }},
};

std::vector<std::string> formatNames() {
  std::vector<std::string> names{csv};
  for (const Format& f : formats) names.push_back(f.name);
  return names;
}

/// The destination of files: a single file, or a folder that appears when all files are complete.
class Destination {
 public:
  Destination(const fs::path& output, bool isFolder) : output_(output), isFolder_(isFolder) { requireAbsent(output); }
  /// Writes files, whose paths begin with `output`, and returns their paths. If one of several files outside of a folder
  /// cannot be written, those before it are removed.
  std::vector<fs::path> write(const Files& files) {
    if (isFolder_ && !draft_) draft_.emplace(output_);
    if (!draft_)
      for (const NewFile& f : files) requireAbsent(f.path);
    std::vector<fs::path> names;
    try {
      for (const NewFile& f : files) {
        const fs::path path = draft_ ? draft_->path() / f.path.lexically_relative(output_) : f.path;
        makeFolder(path.parent_path());
        writeNewFile(path, f.bytes);
        names.push_back(f.path);
      }
    } catch (...) {
      if (!draft_)
        for (const fs::path& written : names) removeFile(written);
      throw;
    }
    return names;
  }
  void finish() {
    if (draft_) draft_->takePlace();
  }

 private:
  fs::path output_;
  bool isFolder_;
  std::optional<DraftFolder> draft_;
};

/// Returns the units that all scenarios of the file have.
Units unitsOfFile(Store& store) {
  if (!store.columns("replicate").empty()) return unitsOf(readStudyResults(store.file()), store.file());
  return unitsOfAll(store.runs(),
                    [&](const StoredRun& run) { return storedScenario(store.file().string(), run.id).units; });
}

/// Writes the tables of one run.
Files tableFiles(Store& store, const ExportRequest& request, const std::string& id) {
  const bool one = request.output.extension() == ".csv";
  const auto known = csvTableNames();
  if (!request.table.empty() && std::ranges::find(known, request.table) == known.end()) {
    const std::string near = closest(request.table, known);
    throw UsageError("--table: there is no table '" + request.table + "'; " +
                     (near.empty() ? "needs one of " + join(known) : "did you mean " + near + "?"));
  }
  if (one && request.table.empty())
    throw UsageError("--output: '" + request.output.string() +
                     "' holds one table; name it with --table, or give a folder for all");
  const auto tables = csvTables(store, id, request.table);
  if (tables.empty())
    throw FileError("'" + store.file().string() + "' has no rows for the table " + request.table +
                    "; `morula export --list` lists its tables");
  const Units units = unitsOfFile(store);
  if (one) return oneTable(tables.front().table, request.output, units);
  Files files;
  addTables(tables, request.output, units, files);
  return files;
}

Exported exportTables(Store& store, const ExportRequest& request) {
  if (request.noComments) throw UsageError("--no-comments: only --format newick has comments; leave it out");
  if (request.time) throw UsageError("--time: csv has all times in one table; leave it out");
  const std::string id = request.run.empty() ? "" : store.find(request.run).id;
  if (id.empty()) store.requireAllIntact();  // also finds rows that belong to no run; checks each run
  for (const StoredRun& run : store.runs())
    if (id.empty() || run.id == id) requireWholeRecord(store, run), tellUnlessFine(store, run);
  requireIntactStudy(store.file());
  const Files files = tableFiles(store, request, id);
  Destination to(request.output, request.output.extension() != ".csv");
  Exported all{{{id, to.write(files)}}};
  to.finish();
  return all;
}

/// Returns the reason why a run cannot be exported among others; "" if it can.
std::string whyNot(const StoredRun& run, const Format& format) {
  if (run.status == RunStatus::running) return "has not finished";
  if (run.status != RunStatus::done && format.wanted == Wanted::surfaces)
    return std::string("did not come to its end: ") + (run.failure.empty() ? name(run.status) : run.failure);
  return {};
}

Exported exportEach(Store& store, const ExportRequest& request, const Format& format) {
  if (request.noComments && std::string_view(format.name) != "newick")
    throw UsageError("--no-comments: only --format newick has comments; leave it out");
  if (request.time && format.wanted == Wanted::tree)
    throw UsageError(std::string("--time: ") + format.name + " has no times; leave --time out");
  if (request.time && format.wanted == Wanted::measures)
    throw UsageError(std::string("--time: ") + format.name + " has the times of all samples; leave --time out");
  std::vector<StoredRun> runs;
  if (request.run.empty()) runs = store.runs();
  else runs = {store.find(request.run)};
  if (runs.empty()) throw FileError("'" + store.file().string() + "': there are no runs in it");
  const bool several = runs.size() > 1;
  const bool oneFile = *format.ending && (!format.mayBeSeries || request.output.extension() == format.ending);
  Destination to(request.output, several || !oneFile);
  Exported all;
  for (const StoredRun& run : runs) {
    if (const std::string why = several ? whyNot(run, format) : ""; !why.empty()) {
      tell("run " + run.id + " is left out, because it " + why, request.quiet);
      continue;
    }
    if (run.status == RunStatus::running)
      throw FileError("'" + store.file().string() + "': run " + run.id +
                      " has not finished; continue it with `morula run --resume`, or run it again");
    fs::path path = request.output;
    if (several) path /= run.id + (format.mayBeSeries && !request.time ? "" : format.ending);
    requireWholeRecord(store, run);
    tellUnlessFine(store, run);
    SurfaceRequest ask{request.noSurfaces ? Wanted::measures : format.wanted, request.time, false, request.execution,
                       request.quiet};
    ask.atEnd = format.mayBeSeries && path.extension() == format.ending && !request.time;
    const ExportedRun exported = exportedRun(store, run, ask);
    all.runs.push_back({run.id, to.write(format.files(exported, path, request))});
  }
  if (all.runs.empty())
    throw FileError("'" + store.file().string() + "': none of its runs has what --format " + format.name + " needs");
  to.finish();
  return all;
}

}  // namespace

std::string formatList() {
  std::string text = "csv: tables (a folder, or FILE.csv with --table)";
  for (const Format& f : formats) text += std::string("; ") + f.name + ": " + f.what;
  return text;
}

std::string formatCalled(const std::string& text) {
  const auto names = formatNames();
  if (std::ranges::find(names, text) != names.end()) return text;
  const std::string near = closest(text, names);
  throw InputError("there is no format '" + text + "'; " +
                   (near.empty() ? "needs one of " + join(names) : "did you mean " + near + "?"));
}

Exported exportRuns(Store& store, const ExportRequest& request) {
  if (request.noSurfaces && request.format != "npz")
    throw UsageError("--no-surfaces: only --format npz has surfaces that may be left out; leave it out");
  if (request.format == csv) return exportTables(store, request);
  if (!request.table.empty()) throw UsageError("--table: only --format csv has tables; leave it out");
  for (const Format& f : formats)
    if (request.format == f.name) return exportEach(store, request, f);
  throw BugError("no format " + request.format);
}

}  // namespace morula

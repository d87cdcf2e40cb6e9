#pragma once
// The formats of `morula export --format`, in a table, and the destination of their files.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/simulation.h"
#include "store/store.h"

namespace morula {

struct ExportRequest {
  std::string format;            // the name of a format
  std::filesystem::path output;  // a file or a folder, which must be absent or an empty folder
  std::string run;               // id or its beginning; "": all runs of the database
  std::optional<double> time;    // [time] time of the surfaces
  std::string table;             // the table, for csv into one file
  bool noComments = false;       // true: newick without its comments
  bool noSurfaces = false;       // true: npz without surfaces, for which a run might be simulated again
  Execution execution;           // for runs that are simulated again
  bool quiet = false;
};

struct ExportedFiles {
  std::string run;  // the run's id; "" for the files of all runs
  std::vector<std::filesystem::path> files;
};

struct Exported {
  std::vector<ExportedFiles> runs;
};

/// Returns a line "csv: tables …" for each format, for --help and messages.
std::string formatList();
/// Returns the name of the format. Throws InputError with the name that was probably meant.
std::string formatCalled(const std::string& text);

/// Writes the files; a folder appears only when it holds all of them. csv: a folder with the tables of all runs, or one
/// table in a file that ends in .csv. Other formats, for one run: a file (tracks, newick, npz; ply and gltf if the name
/// has their ending) or a folder (geff, vtk; ply and gltf: a file for each time). Beside the tables of a folder stands
/// columns.json, and FILE.columns.json beside FILE.csv: the meanings and units of their columns. For several runs: a
/// folder that holds these for each, named by the run's id. Unfinished runs that lack the requested data are left out,
/// with a remark on stderr; if none is left this is an error. Throws UsageError, FileError.
Exported exportRuns(Store& store, const ExportRequest& request);

}  // namespace morula

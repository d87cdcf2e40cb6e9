#pragma once
// The formats of `morula export --format`: a table of them, and the destination of their files.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/world.h"
#include "store/store.h"

namespace morula {

struct ExportRequest {
  std::string format;            // a row's name
  std::filesystem::path output;  // a file or a folder, which must not be there, or be an empty folder
  std::string run;               // id or its beginning; "": all runs of the database
  std::optional<double> time;    // [time] of surfaces
  std::string table;             // csv into one file: which table
  bool noComments = false;       // newick without its comments
  Execution execution;           // of runs that are made again
  bool quiet = false;
};

struct ExportedFiles {
  std::string run;  // its id; "" of all together
  std::vector<std::filesystem::path> files;
};

struct Exported {
  std::vector<ExportedFiles> runs;
};

/// "csv: tables …", a line for each format: for --help and messages.
std::string formatList();
/// The row's name. Throws InputError with the name that was probably meant.
std::string formatCalled(const std::string& text);

/// Writes the files; a folder is there only when all of them are in it. csv: all runs in the same tables, in a folder,
/// or one table in a file that ends in .csv. The others: of one run a file (newick, npz; ply and gltf where the name
/// has their ending) or a folder (vtk; ply and gltf: a file for each time); of several runs a folder with one of these
/// for each, called by the run's id. Runs that are not done, and have not what is asked for, are left out, which stderr
/// says; with none left it is an error. Throws UsageError, FileError.
Exported exportRuns(Store& store, const ExportRequest& request);

}  // namespace morula

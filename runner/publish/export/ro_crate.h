#pragma once
// A run, or a study, as a Process Run Crate: a folder of its files and ro-crate-metadata.json, which tells in JSON-LD the
// program, its input and results, time and place (RO-Crate 1.1, profile https://w3id.org/ro/wfrun/process/0.5).
#include <filesystem>
#include <string>
#include <vector>

#include "store/store.h"

namespace morula {

struct CrateFile {
  enum class Role { object, result, about };  // the run's input, its output, or a text about the program

  std::string path;  // path in the crate, with '/'; its parts are safe names (files/printable.h)
  Role role = Role::object;
  std::string description;
  std::string alternateName = {};     // its path when the run was made; "" if there was none
  std::string content = {};           // the bytes to write, or
  std::filesystem::path source = {};  // the file to copy, or
  bool isThere = false;               // true: the file has been written already
};

/// An action of the program: a run, or all runs of a study.
struct CrateAction {
  std::string name, identifier, command;
  std::string started, ended;  // UTC; "" if unknown
  RunStatus status = RunStatus::done;
  std::string error;                                                     // why it failed; "" unless it did
  std::vector<std::pair<std::string, std::string>> parameters, results;  // names and values that are in no file
};

struct Crate {
  std::string name, description;
  StoredRun run;  // its record tells program and machine
  CrateAction action;
  std::string agent;    // the person who ran it: a name or a URI such as an ORCID; "" if unknown
  std::string license;  // licence of the results, a URI; "" if unknown
  std::vector<CrateFile> files;
};

/// Writes files and metadata into the folder, which must exist. Equal paths are made distinct. Each file has its size and
/// the XXH3-128 of its bytes as `identifier`. Throws FileError.
void writeCrate(Crate crate, const std::filesystem::path& folder);

/// Compares the files of a crate's folder with its metadata. Returns a line for each file that has changed, is missing or
/// is not listed. Throws FileError if the folder is no crate that writeCrate has made.
std::vector<std::string> changedFiles(const std::filesystem::path& crate);

/// The warning on a crate without a licence.
inline constexpr const char* noLicence =
    "the crate names no licence, so strict readers of RO-Crate 1.1 reject it; name one, as in --license CC-BY-4.0";

/// Returns the URI of a licence: a URI unchanged, an SPDX identifier (in any case) as https://spdx.org/licenses/…; ""
/// for "". Throws InputError for other texts, with the identifier that was probably meant.
std::string licenseUri(const std::string& license);

}  // namespace morula

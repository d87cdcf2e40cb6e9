#pragma once
// A run as a Process Run Crate: a folder of its files and ro-crate-metadata.json, which tells in JSON-LD the program,
// its input and results, time and place (RO-Crate 1.1, profile https://w3id.org/ro/wfrun/process/0.5).
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

struct CrateRun {
  StoredRun run;
  std::string agent;    // the person who ran it: a name or a URI such as an ORCID; "" if unknown
  std::string license;  // licence of the results, a URI; "" if unknown
  std::vector<CrateFile> files;
};

/// Writes files and metadata into the folder, which must exist. Equal paths are made distinct. Throws FileError.
void writeCrate(CrateRun crate, const std::filesystem::path& folder);

/// Returns the URI of a licence: a URI unchanged, an SPDX identifier (in any case) as https://spdx.org/licenses/…; ""
/// for "". Throws InputError for other texts, with the identifier that was probably meant.
std::string licenseUri(const std::string& license);

}  // namespace morula

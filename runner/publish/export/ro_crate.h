#pragma once
// A run as a Process Run Crate: a folder with its files and ro-crate-metadata.json, which says in JSON-LD which program
// made what out of what, when and where (RO-Crate 1.1, profile https://w3id.org/ro/wfrun/process/0.5).
#include <filesystem>
#include <string>
#include <vector>

#include "store/store.h"

namespace morula {

struct CrateFile {
  enum class Role { object, result, about };  // the run's input, its output, or about the program

  std::string path;  // in the crate, with '/'; its parts are safe names (files/printable.h)
  Role role = Role::object;
  std::string description;
  std::string alternateName = {};     // where it was when the run was made; "" if it was nowhere
  std::string content = {};           // what to write, or
  std::filesystem::path source = {};  // which file to copy; or
  bool isThere = false;               // nothing: it has been written already
};

struct CrateRun {
  StoredRun run;
  std::string agent;    // who ran it: a name or a URI such as an ORCID; "" if unknown
  std::string license;  // of the results: a URI; "" if none is known
  std::vector<CrateFile> files;
};

/// Writes files and metadata into the folder, which is there. Files of one path get different ones. Throws FileError.
void writeCrate(CrateRun crate, const std::filesystem::path& folder);

/// The URI of a licence: a URI as it is, an SPDX identifier (case does not count) as
/// https://spdx.org/licenses/…; "" for "". Throws InputError for anything else, with what was probably meant.
std::string licenseUri(const std::string& license);

}  // namespace morula

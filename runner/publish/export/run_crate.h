#pragma once
// The content of a crate of a stored run: its documents, database, golden file and pictures.
#include "export/ro_crate.h"

namespace morula {

/// Writes run.db into the folder, which must exist, and returns the crate with the other files named. `pictures`: the
/// folder of the run's pictures; "": beside a database of one run. Throws FileError.
Crate crateOf(Store& store, const StoredRun& run, const std::string& pictures, const std::filesystem::path& folder);

/// Describes the file of a document with this role, as "dna": "The genes that the scenario names".
const char* describeRole(const std::string& role);

}  // namespace morula

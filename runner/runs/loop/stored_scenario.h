#pragma once
// The source of a verb's input: a scenario file, or a run in a database.
#include <string>

#include "scenario/scenario.h"
#include "store/store.h"

namespace morula {

/// True if the file begins as SQLite's do. Throws FileError if reading it fails.
bool isDatabase(const std::string& file);

/// The scenario of a stored run, as it was run but for `changes`. `run`: its id or the beginning of it; "": the only or
/// latest one.
Scenario storedScenario(const std::string& database, const std::string& run, const std::vector<Override>& changes = {});

/// Throws FileError if the file is damaged, or the record of the run was changed since it was stored
/// (Store::changedRecord, lostCells): whatever is made of it would be of another run.
void requireWholeRecord(Store& store, const StoredRun& run);

/// Says on stderr, once in a process, if the run is not fine: the run failed, or ended in a state that cannot be.
void tellUnlessFine(Store& store, const StoredRun& run);

/// requireWholeRecord without the hashes on the way, and tellUnlessFine. For verbs that show a run.
void requireToShow(Store& store, const StoredRun& run);

/// A scenario file, which may name files outside of its folder if `allowOutside`; or the scenario of a stored run.
Scenario anyScenario(const std::string& file, const std::string& run, bool allowOutside);

}  // namespace morula

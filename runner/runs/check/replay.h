#pragma once
// A stored run once more, from its record alone: under which other conditions, and the same bits?
#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.h"
#include "simulation/simulation.h"
#include "store/store.h"
#include "system/json.h"

namespace morula {

struct Replay {
  std::vector<Item> conditions;
  std::vector<ValueDifference> record;  // what was changed in the record itself; then nothing was run
  std::string hashBefore, hashNow;      // of the final state, or how it failed
  std::size_t hashesBefore = 0, hashesNow = 0;
  std::optional<std::uint64_t> firstDifference;  // [steps]
  std::vector<TableDifference> tables;
  std::vector<std::string> notCompared;  // which rows, and why

  bool sameBits() const {
    return record.empty() && hashBefore == hashNow && hashesBefore == hashesNow && !firstDifference &&
           std::all_of(tables.begin(), tables.end(), [](const auto& t) { return t.differing == 0; });
  }
};

struct ReplayQuestion {
  Execution execution;
  std::string command;      // as typed, for the record of the run of now
  std::string databaseOut;  // where that is stored, too; "": nowhere
  bool quiet = false;
};

/// Runs the stored run `before` again, which has ended, and compares. A record that was changed since it was stored is
/// not run.
Replay replay(Store& store, const StoredRun& before, const Scenario& scenario, const ReplayQuestion& question);

/// Describes a replay for people.
std::string describe(const Replay& replay, const StoredRun& run);
Json toJson(const Replay& replay, const StoredRun& run);

}  // namespace morula

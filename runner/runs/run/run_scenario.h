#pragma once
// One run from end to end: simulate, store, check, draw.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/result_state.h"
#include "loop/simulate.h"
#include "tracks/measured.h"

namespace morula {

struct RunSettings {
  Execution execution;
  std::filesystem::path folder;  // for pictures
  std::filesystem::path database;
  std::string command = {};  // as typed, for the record
  bool changed = false;      // by --set or --seed: its golden file does not apply
  bool check = true, draw = true;
  bool quiet = false;
  std::optional<tracks::MeasuredCells> against = {};  // measured cells that the run is compared with
  std::uint64_t checkpointEvery = 0;                  // [steps] 0: only when a signal ends the run
  bool resume = false;                                // go on from the last checkpoint, if there is one
  std::string mother = {};          // with `resume`: the only other run to go on from; "": any of the database
  std::optional<bool> hashes = {};  // of states on the way; absent: where the checks need them
  /// True if the run is compared with its golden and its conditions are checked.
  bool isChecked() const { return check && !changed; }
};

struct RunOutcome {
  std::string id;
  std::optional<std::uint64_t> resumedAt;  // [steps]
  std::string mother;                      // id of the run that it went on from; "" if none
  bool canBeResumed = false;               // it left a checkpoint
  RunEnd end;
  std::optional<Sample> last;  // of a run that came to its end
  std::optional<CheckReport> checks;
  std::string whyNotChecked;           // against a golden
  std::vector<CheckResult> sanity;     // of a run with bodies that came to its end, whatever else was checked
  std::optional<bool> isSane() const;  // or the scenario says that it need not be; absent: not measured
  CheckReport sanityReport(const Scenario& scenario) const;
  ResultState state() const;  // of all of these
  std::vector<std::string> pictures;
  std::vector<DivisionRecord> ambiguous;  // divisions across the longest extent of cells that have none
  std::vector<std::string> experiments;   // [experimentLines]
  std::string stopped;                    // the condition of stop.when that ended the run, as a scenario writes it; ""
  std::string settled;                    // [settledText]
  std::string unsettled;                  // [unsettledText]
  std::string reference;                  // [positionsText]
  std::vector<AgainstStage> against;      // the run compared with measured cells
  std::filesystem::path database;         // that holds the run: another one than asked for where a process held that
};

/// Runs the scenario as `settings` say. A run that a signal stops is stored as killed.
RunOutcome runScenario(const Scenario& scenario, const RunSettings& settings);

/// Describes a run for people, on several lines.
std::string describe(const RunOutcome& outcome, const Scenario& scenario, const RunSettings& settings);
/// Writes the JSON of `morula run --json`.
Json toJson(const RunOutcome& outcome, const Scenario& scenario);

}  // namespace morula

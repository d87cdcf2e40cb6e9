#pragma once
// The database of a run: what joins it during the run and at the end.
#include <cstdint>
#include <optional>
#include <string>

#include "loop/run.h"
#include "loop/simulate.h"
#include "run/run_scenario.h"
#include "store/store.h"

namespace morula {

class RunFile {
 public:
  /// Opens the database and makes the folders, so that errors of files are found before time is spent. `hasGolden`: the
  /// run is compared with a golden.
  RunFile(const Scenario& scenario, const RunSettings& settings, bool hasGolden);

  Store& store() { return store_; }
  const std::string& id() const { return id_; }
  /// Stores records during the run, and keeps those that a golden holds if the run has one.
  RecordSink sink();
  /// Enters the run, or resumes it if settings ask for that. Returns the step [steps] from which it goes on, if any.
  std::optional<std::uint64_t> begin(Run& run, const RecordOptions& recording);
  /// The kept records, at the end.
  KeptForGolden takeKept() { return std::move(kept_); }
  /// Stores the end, and the checkpoint that a finished run keeps; in a file beside the database if a process holds
  /// that. Returns the file.
  std::filesystem::path finish(const RunEnd& end, const RunResults& results, const std::optional<Checkpoint>& last);
  /// Returns the id of the run that this one went on from; "" if none.
  const std::string& mother() const { return record_.mother; }

 private:
  const RunSettings& settings_;
  bool hasGolden_;
  Store store_;
  RunRecord record_;
  std::string id_;
  KeptForGolden kept_;
};

}  // namespace morula

#include "loop/stored_scenario.h"

#include <set>
#include <utility>

#include "base/error.h"
#include "files/content.h"
#include "store/run_state.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {

bool isDatabase(const std::string& file) { return contentOfFile(file) == Content::database; }

namespace {

void refuseIf(const std::vector<ValueDifference>& changed, Store& store, const StoredRun& run) {
  if (changed.empty()) return;
  const ValueDifference& first = changed.front();
  throw FileError("'" + store.file().string() + "': the record of run " + run.id +
                  " was changed since it was stored: " + first.table + ", " + first.row + ": " +
                  (first.column.empty() ? "the row" : first.column) + " is " + first.stored + ", but " +
                  first.recomputed +
                  " follows from the stored data; restore the file from a copy, or run the scenario again");
}

}  // namespace

void requireWholeRecord(Store& store, const StoredRun& run) {
  refuseIf(store.changedRecord(run.id), store, run);
  refuseIf(store.lostCells(run), store, run);
  store.requireIntact(run.id);
}

void tellUnlessFine(Store& store, const StoredRun& run) {
  static std::set<std::pair<std::filesystem::path, std::string>> told;
  if (!told.emplace(store.file(), run.id).second) return;
  if (const std::string remark = remarkOn(store, run); !remark.empty()) tell(remark, false);
}

void requireToShow(Store& store, const StoredRun& run) {
  refuseIf(store.changedRecord(run.id), store, run);
  refuseIf(store.lostCells(run), store, run);
  store.requireShownIntact(run.id);
  tellUnlessFine(store, run);
}

Scenario storedScenario(const std::string& database, const std::string& run, const std::vector<Override>& changes) {
  auto store = Store::openForReading(database);
  const auto stored = store.find(run);
  refuseIf(store.changedRecord(stored.id), store, stored);
  std::string resolved;
  std::vector<NamedFile> files;
  for (const auto& document : store.documents(stored.id)) {
    if (document.role == "resolved") resolved = document.content;
    else if (document.role == "mesh" || document.role == "shell")
      files.push_back({document.role, document.path, document.content});
  }
  if (resolved.empty()) throw FileError("'" + database + "': run " + stored.id + " has no scenario stored with it");
  return readScenario(resolved, database, "", changes, files);
}

Scenario anyScenario(const std::string& file, const std::string& run, bool allowOutside) {
  if (isDatabase(file)) {
    auto store = Store::openForReading(file);
    requireToShow(store, store.find(run));
    return storedScenario(file, run);
  }
  if (!run.empty()) throw UsageError("--run chooses a run of a database, and '" + file + "' is not a database");
  return loadScenario(file, {}, allowOutside);
}

}  // namespace morula

#include "run/run_file.h"

#include <fmt/format.h>

#include "database/store_error.h"
#include "files/folders.h"
#include "run/resume_run.h"
#include "system/console.h"

namespace morula {
namespace {

Store openedFor(const RunSettings& settings) {
  makeFolder(settings.database.parent_path());
  Store store = Store::openForWriting(settings.database);
  if (settings.draw) makeFolder(settings.folder);
  return store;
}

}  // namespace

RunFile::RunFile(const Scenario& scenario, const RunSettings& settings, bool hasGolden)
    : settings_(settings),
      hasGolden_(hasGolden),
      store_(openedFor(settings)),
      record_(recordOf(scenario, settings.execution, settings.command)),
      id_(runId(record_)) {}

RecordSink RunFile::sink() {
  return [this](const RunResults& records) {
    store_.record(id_, records);
    if (hasGolden_) kept_.add(records);
  };
}

std::optional<std::uint64_t> RunFile::begin(Run& run, const RecordOptions& recording) {
  std::optional<std::uint64_t> step;
  if (settings_.resume) step = resumeRun(store_, record_, run, recording, settings_.mother, settings_.quiet);
  if (!step) store_.begin(record_);
  if (const auto left = store_.checkpointStep(id_); left && !settings_.resume)
    tell(fmt::format("an earlier run was stopped at step {}; --resume continues it", *left), settings_.quiet);
  return step;
}

std::filesystem::path RunFile::finish(const RunEnd& end, const RunResults& results,
                                      const std::optional<Checkpoint>& last) {
  try {
    store_.finish(id_, end, results, last);
  } catch (const BusyError& error) {
    store_ = store_.finishBeside(id_, end, results, last);
    tellError(fmt::format("{}; the run is stored in {}", error.what(), store_.file().string()));
  }
  return store_.file();
}

}  // namespace morula

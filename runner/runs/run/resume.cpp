#include "run/resume.h"

#include <fmt/format.h>

#include "base/error.h"
#include "simulation/checkpoint.h"
#include "store/provenance.h"
#include "system/console.h"
#include "system/usage_error.h"

namespace morula {
namespace {

/// What makes one run_id another one.
std::string differences(const RunRecord& there, const RunRecord& here) {
  std::string text;
  for (const auto& [name, item, before, now] : compareIdentity(there, here))
    if (before != now) text += (text.empty() ? "" : "; ") + fmt::format("{} ({} then, {} now)", item, before, now);
  return text;
}

/// Why there is nothing to go on from.
std::string whyNot(Store& store, const RunRecord& record) {
  const std::string id = runId(record);
  std::optional<StoredRun> other;
  for (const StoredRun& run : store.runs()) {
    if (run.id == id && run.status == RunStatus::done) return "run " + id + " is finished";
    if (run.id == id) return "run " + id + " left no checkpoint (--checkpoint-every makes them)";
    if (run.record.scenario == record.scenario && run.status != RunStatus::done) other = run;
  }
  if (other)
    return "run " + other->id + " of " + record.scenario +
           " is another one; what differs: " + differences(other->record, record);
  return "there is no unfinished run of " + record.scenario + " in " + store.file().string();
}

std::string samplesOf(const std::optional<double>& every) {
  return every ? fmt::format("samples every {}", *every) : "samples at start and end";
}

std::string hashesOf(const std::optional<std::uint64_t>& every) {
  return every ? fmt::format("state hashes every {}", *every) : "no state hashes";
}

/// What was recorded in another way cannot be made up for.
void requireSameRecords(const Checkpoint& c, const RecordOptions& now) {
  if (c.every == now.every && c.hashEvery == now.hashEvery) return;
  throw UsageError(fmt::format(
      "--resume: the checkpoint was made with {} and {}, and now it is {} and {}; record as then (--no-check and the "
      "scenario's record and check decide), or leave out --resume to start from the beginning",
      samplesOf(c.every), hashesOf(c.hashEvery), samplesOf(now.every), hashesOf(now.hashEvery)));
}

}  // namespace

std::optional<std::uint64_t> resumeRun(Store& store, const RunRecord& record, World& world, Recorder& recorder,
                                       FrameCollector& frames, bool quiet) {
  const auto run = store.resume(record);
  if (!run) {
    tell("nothing to resume: " + whyNot(store, record) + "; starting from the beginning", quiet);
    return std::nullopt;
  }
  requireSameRecords(run->checkpoint, recorder.options());
  try {
    restoreState(world, run->checkpoint.state);
    store.eachRecord(run->id, [&](const RunResults& records) { recorder.resume(world, records); });
    frames.resume(world, run->frames);
  } catch (const InputError& error) {
    throw FileError(store.file().string() + ": run " + run->id + " cannot be resumed: " + error.what() +
                    "; leave out --resume to start from the beginning");
  }
  tell(fmt::format("{} goes on from step {}, time {:.6g}", record.scenario, world.clock.step, world.clock.time), quiet);
  return world.clock.step;
}

}  // namespace morula

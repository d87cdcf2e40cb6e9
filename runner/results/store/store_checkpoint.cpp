// Stopping a run at a checkpoint, and resuming it.
#include "base/error.h"
#include "store/rows.h"
#include "store/run_tables.h"
#include "store/seal.h"
#include "store/store.h"

namespace morula {
namespace {

/// Returns the step of the file's checkpoint. Absent if there is none, or if its intervals of samples and hashes are
/// not those of `c`.
std::optional<std::uint64_t> keptStep(Database& db, const std::string& id, const Checkpoint& c) {
  Statement s(db, "SELECT step FROM checkpoint WHERE run_id = ? AND every IS ? AND hash_every IS ?");
  if (!s.start(id, c.every, c.hashEvery).next()) return std::nullopt;
  return s.natural(0);
}

void addFrames(Database& db, const std::string& id, const FrameSource& frames) {
  Statement there(db, "SELECT count(*) FROM checkpoint_frame WHERE run_id = ?");
  there.start(id).next();
  Statement insert(db, sqlTable<FrameRow>().insert());
  for (std::size_t i = there.natural(0); i < frames.count; ++i) insert.run(id, i, FrameRow{frames.bytes(i)});
}

}  // namespace

std::optional<std::uint64_t> Store::checkpointStep(const std::string& id) {
  Statement s(db_,
              "SELECT step FROM checkpoint WHERE run_id = ? AND NOT EXISTS (SELECT 1 FROM run WHERE run.run_id = "
              "checkpoint.run_id AND status = 'done')");
  if (!s.start(id).next()) return std::nullopt;
  return s.natural(0);
}

std::optional<Checkpoint> Store::checkpointOf(const std::string& id) {
  auto kept = rowsOf<CheckpointRow>(db_, "", id);
  if (kept.empty()) return std::nullopt;
  return std::move(kept.front().of);
}

bool Store::keepCheckpoint(const std::string& id, const Checkpoint& checkpoint, const RunResults& records,
                           const FrameSource& frames) {
  const auto attempt = attempts_.find(id);
  MORULA_CHECK(attempt != attempts_.end(), "a run is begun before it is stopped");
  Transaction transaction(db_);
  Statement status(db_, "SELECT status FROM run WHERE run_id = ?");
  if (!status.start(id).next()) insertRun(db_, id, attempt->second.record, attempt->second.started, nullptr);
  else if (status.text(0) == name(RunStatus::done)) return false;
  const auto kept = keptStep(db_, id, checkpoint);
  if (kept && *kept > checkpoint.step) return true;
  attempt->second.storesOnTheWay = false;  // from now on the file has only records up to the checkpoint
  attempt->second.until = {};
  if (!kept) {
    deleteRows(db_, id);
    deleteRows(db_, id, [](TablePart part) { return part == TablePart::checkpoint; });
    sealRun(db_, id);
  }
  const RecordedUntil until = kept ? recordedUntil(id, *kept) : RecordedUntil{};
  takeOver(id, until);
  insertRecords(db_, id, records, kept);
  replaceCheckpoint(db_, id, checkpoint);
  addFrames(db_, id, frames);
  extendSeal(db_, id, until);
  sealRun(db_, id, [](TablePart part) { return part == TablePart::checkpoint || part == TablePart::record; });
  transaction.commit();
  return true;
}

std::optional<ResumedRun> Store::resume(const RunRecord& record) {
  const std::string id = runId(record);
  Transaction transaction(db_);
  if (!checkpointStep(id)) return std::nullopt;
  requireIntact(id);
  ResumedRun run{id, *checkpointOf(id), {}};
  const StoredRun stopped = find(id);
  attempts_[id] = {record, stopped.started};
  attempts_[id].record.mother = stopped.record.mother;
  attempts_[id].record.motherTime = stopped.record.motherTime;
  for (FrameRow& frame : rowsOf<FrameRow>(db_, "", id)) run.frames.push_back(std::move(frame.content));
  restartRun(db_, id, attempts_[id].started);
  sealRun(db_, id, [](TablePart part) { return part == TablePart::record || part == TablePart::end; });
  transaction.commit();
  return run;
}

}  // namespace morula

// Runs that stop on the way, and go on.
#include "base/error.h"
#include "database/measure_columns.h"
#include "store/rows.h"
#include "store/store.h"

namespace morula {

namespace {

/// The step of the checkpoint that the file has, if samples and hashes were recorded for it in the same way.
std::optional<std::uint64_t> keptStep(Database& db, const std::string& id, const Checkpoint& c) {
  Statement s(db, "SELECT step FROM checkpoint WHERE run_id = ? AND every IS ? AND hash_every IS ?");
  if (!s.start(id, c.every, c.hashEvery).next()) return std::nullopt;
  return s.natural(0);
}

void replaceCheckpoint(Database& db, const std::string& id, const Checkpoint& c) {
  Statement(db, insertInto("checkpoint", "run_id, step, made, every, hash_every, state") +
                    " ON CONFLICT DO UPDATE SET step = excluded.step, "
                    "made = excluded.made, every = excluded.every, hash_every = excluded.hash_every, "
                    "state = excluded.state")
      .run(id, c.step, utcNow(), c.every, c.hashEvery, Blob{c.state});
}

void addFrames(Database& db, const std::string& id, const FrameSource& frames) {
  Statement there(db, "SELECT count(*) FROM checkpoint_frame WHERE run_id = ?");
  there.start(id).next();
  Statement insert(db, insertInto("checkpoint_frame", "run_id, number, content"));
  for (std::size_t i = there.natural(0); i < frames.count; ++i) {
    const std::string bytes = frames.bytes(i);
    insert.run(id, i, Blob{bytes});
  }
}

}  // namespace

std::optional<std::uint64_t> Store::checkpointStep(const std::string& id) {
  Statement s(db_, "SELECT step FROM checkpoint WHERE run_id = ?");
  if (!s.start(id).next()) return std::nullopt;
  return s.natural(0);
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
  if (!kept) {
    deleteResults(db_, id);
    Statement(db_, "DELETE FROM checkpoint WHERE run_id = ?").run(id);  // and its frames
  }
  takeOver(id, kept);
  insertRecords(db_, id, records, kept);
  replaceCheckpoint(db_, id, checkpoint);
  addFrames(db_, id, frames);
  transaction.commit();
  return true;
}

std::optional<ResumedRun> Store::resume(const RunRecord& record) {
  const std::string id = runId(record);
  Transaction transaction(db_);
  Statement row(
      db_,
      "SELECT step, every, hash_every, state, started, status FROM checkpoint JOIN run USING (run_id) "
      "WHERE run_id = ?");
  if (!row.start(id).next()) return std::nullopt;
  ResumedRun run{id, {}, {}};
  Checkpoint& c = run.checkpoint;
  c.step = row.natural(0);
  if (!row.isNull(1)) c.every = row.real(1);
  if (!row.isNull(2)) c.hashEvery = row.natural(2);
  c.state = row.text(3);
  attempts_[id] = {record, row.line(4)};
  Statement frame(db_, "SELECT content FROM checkpoint_frame WHERE run_id = ? ORDER BY number");
  for (frame.start(id); frame.next();) run.frames.push_back(frame.text(0));
  restartRun(db_, id, attempts_[id].started);
  transaction.commit();
  return run;
}

}  // namespace morula

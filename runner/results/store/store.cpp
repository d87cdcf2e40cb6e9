// Opening a file, and the life of a run in it.
#include "store/store.h"

#include <algorithm>

#include "base/error.h"
#include "database/store_error.h"
#include "store/result_file.h"
#include "store/rows.h"
#include "store/run_tables.h"
#include "store/seal.h"
#include "system/clock.h"

namespace morula {
namespace {

/// Returns the run of this id, if the file has it.
std::optional<StoredRun> findEarlier(Database& db, const std::string& id) {
  Statement s(db, sqlTable<StoredRun>().select(db, "run_id = ?"));
  if (!s.start(id).next()) return std::nullopt;
  return s.row<StoredRun>();
}

/// Copies the run's rows whose `column`, time or step, is above `after`.
template <class Number>
void copyRows(Database& from, Database& to, const SqlTable& table, const std::string& id, const char* column,
              Number after) {
  Statement rows(from,
                 "SELECT " + table.names() + " FROM " + table.info.name + " WHERE run_id = ? AND " + column + " > ?");
  Statement insert(to, table.insert());
  for (rows.start(id, after); rows.next();) insert.runWith(rows);
}

constexpr double secondsBetweenFlushes = 5;  // [s] of records that a killed program may lose

bool isOfEnd(TablePart part) { return part == TablePart::record || part == TablePart::end; }
bool isOfRecord(TablePart part) { return part == TablePart::record; }

void deleteRun(Database& db, const std::string& id) {
  Statement(db, "DELETE FROM run WHERE run_id = ?").run(id);  // also deletes, by foreign keys, all rows of the run
  db.execute("DELETE FROM document WHERE hash NOT IN (SELECT hash FROM run_document)");
}

[[noreturn]] void reportNondeterminism(const Database& db, const std::string& id, const StoredRun& earlier,
                                       const std::string& computed) {
  throw NondeterminismError(
      db.file().string() + ": run " + id +
          ": NONDETERMINISM: the same scenario, seed and build gave another result; stored " + earlier.stateHash +
          " (" + earlier.started + ", " + earlier.record.machine.cpu + ", " + earlier.record.isa + ", threads " +
          std::to_string(earlier.record.threads) + "), now " + computed +
          "; the stored run is kept. This is a bug or broken hardware; `morula explain` finds the first difference",
      id, earlier.stateHash, computed);
}

}  // namespace

Store Store::openForWriting(const std::filesystem::path& file, Options options) {
  Database db(file, Database::Mode::create, options.patience);
  if (db.readOnly())
    throw StoreError(file.string() + ": the file is not writable; change its permissions or give another file");
  makeTables(db);
  configure(db);
  return Store(std::move(db));
}

Store Store::temporary() {
  Database db("the temporary database", Database::Mode::temporary, std::chrono::seconds(1));
  makeTables(db);
  configure(db);
  return Store(std::move(db));
}

Store Store::inMemory(std::string_view bytes) {
  Database db = Database::inMemory("the saved state", bytes);
  if (bytes.empty()) makeTables(db);
  else requireTables(db);
  configure(db);
  return Store(std::move(db));
}

Store Store::openForReading(const std::filesystem::path& file, Options options) {
  Database db(file, Database::Mode::existing, options.patience);
  requireTables(db);
  return Store(std::move(db));
}

std::string Store::begin(const RunRecord& record) {
  const std::string id = runId(record);
  const Attempt& attempt = attempts_[id] = {record, utcNow()};
  if (recorded_) deleteRows(*recorded_, id);
  Transaction transaction(db_);
  if (const auto earlier = findEarlier(db_, id)) {
    if (earlier->status == RunStatus::done) return id;
    if (checkpointStep(id)) {
      restartRun(db_, id, attempt.started);
      sealRun(db_, id, isOfEnd);
      transaction.commit();
      return id;
    }
    deleteRun(db_, id);
  }
  insertRun(db_, id, attempt.record, attempt.started, nullptr);
  sealRun(db_, id);
  transaction.commit();
  attempts_[id].storesOnTheWay = true;
  return id;
}

void Store::record(const std::string& id, const RunResults& records) {
  if (!recorded_) {
    recorded_.emplace("the records of a run that goes on", Database::Mode::temporary, std::chrono::seconds(1));
    makeTables(*recorded_);
  }
  recorded_->execute("BEGIN");
  insertRecords(*recorded_, id, records);
  recorded_->execute("COMMIT");
  if (const auto attempt = attempts_.find(id); attempt != attempts_.end()) flush(id, attempt->second);
}

void Store::flush(const std::string& id, Attempt& attempt) {
  const double now = seconds(ClockKind::wall);
  if (!attempt.storesOnTheWay || now - attempt.flushed < secondsBetweenFlushes) return;
  const bool isFirst = attempt.flushed == 0;
  attempt.flushed = now;
  if (isFirst) return;  // a short run is stored once
  const auto patience = db_.setPatience(std::chrono::milliseconds(0));
  try {
    Transaction transaction(db_);
    takeOver(id, attempt.until);
    extendSeal(db_, id, attempt.until);
    transaction.commit();
    const auto last = [&](const char* what) {
      Statement s(*recorded_, std::string("SELECT max(") + what + " WHERE run_id = ?");
      s.start(id).next();
      return s.isNull(0) ? -1 : s.real(0);
    };
    attempt.until = {last("time) FROM sample"), static_cast<std::int64_t>(last("step) FROM step_hash"))};
  } catch (const BusyError&) {}  // the records are stored the next time, or at the end
  db_.setPatience(patience);
}

RecordedUntil Store::recordedUntil(const std::string& id, std::uint64_t step) {
  // All rows but hashes are selected by their sample's time.
  Statement last(db_, "SELECT max(time) FROM sample WHERE run_id = ? AND step <= ?");
  const bool has = last.start(id, step).next() && !last.isNull(0);
  return {has ? last.real(0) : -1, static_cast<std::int64_t>(step)};
}

void Store::takeOver(const std::string& id, const RecordedUntil& until) {
  if (!recorded_) return;
  for (const SqlTable* t : runTables()) {
    if (!growsDuringRun(t->info.part)) continue;
    const char* column = recordColumn(*t);
    if (column == std::string_view("time")) copyRows(*recorded_, db_, *t, id, column, until.time);
    else copyRows(*recorded_, db_, *t, id, column, until.step);
  }
}

void Store::finish(const std::string& id, const RunEnd& end, const RunResults& results,
                   const std::optional<Checkpoint>& last) {
  const auto attempt = attempts_.find(id);
  MORULA_CHECK(attempt != attempts_.end(), "a run is begun before it is finished");
  MORULA_CHECK(end.status != RunStatus::running, "a finished run does not run");
  MORULA_CHECK(end.status != RunStatus::done || end.stateHash, "a run that is done has a state hash");
  Transaction transaction(db_);
  const auto commit = [&] { transaction.commit(), attempts_.erase(attempt); };
  if (const auto earlier = findEarlier(db_, id)) {
    if (earlier->status == RunStatus::done) {
      // An incomplete run is no evidence against a complete one.
      if (end.status == RunStatus::killed || end.want != Want::nothing) return;
      const std::string computed = end.status == RunStatus::done ? end.stateHash->text() : "failed: " + end.failure;
      if (earlier->stateHash != computed) reportNondeterminism(db_, id, *earlier, computed);
    }
    if (end.status == RunStatus::killed) {
      endRun(db_, id, end);
      if (checkpointStep(id).value_or(0) <= end.steps) {  // otherwise the file holds more of this run
        deleteRows(db_, id);
        takeOver(id);
        insertResults(db_, id, results);
        sealRun(db_, id, [](TablePart part) { return part != TablePart::checkpoint; });
      } else {
        sealRun(db_, id, isOfRecord);
      }
      return commit();
    }
    if (end.want != Want::nothing && checkpointStep(id)) {  // the run can be resumed on a larger machine
      endRun(db_, id, end);
      sealRun(db_, id, isOfRecord);
      return commit();
    }
    if (attempt->second.until.time >= 0 || attempt->second.until.step >= 0) {
      endRun(db_, id, end);
      takeOver(id, attempt->second.until);
      insertResults(db_, id, results);
      if (last && end.status == RunStatus::done) replaceCheckpoint(db_, id, *last);
      sealRun(db_, id);
      return commit();
    }
    deleteRun(db_, id);
  }
  insertRun(db_, id, attempt->second.record, attempt->second.started, &end);
  takeOver(id);
  insertResults(db_, id, results);
  if (last && end.status == RunStatus::done) replaceCheckpoint(db_, id, *last);
  sealRun(db_, id);
  commit();
}

Store Store::finishBeside(const std::string& id, const RunEnd& end, const RunResults& results,
                          const std::optional<Checkpoint>& last) {
  const auto attempt = attempts_.find(id);
  MORULA_CHECK(attempt != attempts_.end(), "a run is begun before it is finished");
  std::filesystem::path beside = file();
  beside.replace_filename(file().stem().string() + "-" + id + ".db");
  Store other = openForWriting(beside);
  other.begin(attempt->second.record);
  other.attempts_[id].started = attempt->second.started;
  other.recorded_ = std::move(recorded_);
  other.finish(id, end, results, last);
  return other;
}

void Store::addChecks(const std::string& id, const std::vector<CheckResult>& checks) {
  Transaction transaction(db_);
  if (!findEarlier(db_, id)) throw StoreError(db_.file().string() + ": no run " + id + " to add checks to");
  Statement forget(db_, "DELETE FROM check_result WHERE run_id = ? AND kind = ?");
  for (const CheckResult& check : checks) forget.run(id, check.kind);
  insertChecks(db_, id, checks);
  sealRun(db_, id, [](TablePart part) { return part == TablePart::checks; });
  transaction.commit();
}

void Store::putBulletSamples(const std::string& id, const std::string& baseline, const std::vector<Sample>& samples) {
  Transaction transaction(db_);
  if (!findEarlier(db_, id)) throw StoreError(db_.file().string() + ": no run " + id + " to add samples to");
  Statement(db_, "DELETE FROM bullet_sample WHERE run_id = ?").run(id);
  insertBulletSamples(db_, id, baseline, samples);
  sealRun(db_, id, [](TablePart part) { return part == TablePart::bullet; });
  transaction.commit();
}

void Store::copyRun(const std::string& id, const std::filesystem::path& file) {
  Statement(db_, "VACUUM INTO ?").run(file.string());
  Database copy(file, Database::Mode::existing, std::chrono::seconds(1));
  for (const std::string& table : tableNames(copy)) {
    const auto columns = columnNames(copy, table);
    const auto has = [&](const char* column) { return std::ranges::find(columns, column) != columns.end(); };
    if (has("run_id")) Statement(copy, "DELETE FROM " + sqlName(table) + " WHERE run_id <> ?").run(id);
    else if (table == "timing")
      Statement(copy, "DELETE FROM timing WHERE task_id NOT IN (SELECT task_id FROM task WHERE run_id = ?)").run(id);
    else if (table != "document") copy.execute("DROP TABLE " + sqlName(table));  // a table on a whole study
  }
  configure(copy);
  copy.execute("DELETE FROM document WHERE hash NOT IN (SELECT hash FROM run_document)");
  copy.execute("DELETE FROM checkpoint; DELETE FROM checkpoint_frame");
  sealRun(copy, id, [](TablePart part) { return part == TablePart::checkpoint; });
  copy.execute("VACUUM");
}

}  // namespace morula

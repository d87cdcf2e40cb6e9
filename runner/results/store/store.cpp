// Opening a file, and the life of a run in it.
#include "store/store.h"

#include "base/error.h"
#include "database/schema.h"
#include "database/store_error.h"
#include "store/rows.h"

namespace morula {

namespace {

/// What the file says of a run that is already there.
struct Earlier {
  std::string status, stateHash, started, cpu, isa;
  std::int64_t threads;
};

std::optional<Earlier> findEarlier(Database& db, const std::string& id) {
  Statement s(db, "SELECT status, state_hash, started, cpu, isa, threads FROM run WHERE run_id = ?");
  if (!s.start(id).next()) return std::nullopt;
  return Earlier{s.text(0), s.text(1), s.text(2), s.text(3), s.text(4), s.integer(5)};
}

/// The rows for which `which` holds, by the names of their columns.
template <class... Values>
void copyRows(Database& from, Database& to, const std::string& table, const std::string& which,
              const Values&... values) {
  std::string names, places;
  Statement columns(from, "SELECT name FROM pragma_table_info(?)");
  for (columns.start(table); columns.next();) {
    names += (names.empty() ? "" : ", ") + columns.text(0);
    places += places.empty() ? "?" : ", ?";
  }
  Statement rows(from, "SELECT " + names + " FROM " + table + " WHERE " + which);
  Statement insert(to, "INSERT INTO " + table + " (" + names + ") VALUES (" + places + ")");
  for (rows.start(values...); rows.next();) insert.runWith(rows);
}

void deleteRun(Database& db, const std::string& id) {
  Statement(db, "DELETE FROM run WHERE run_id = ?").run(id);  // and, by its foreign keys, all rows of the run
  db.execute("DELETE FROM document WHERE hash NOT IN (SELECT hash FROM run_document)");
}

[[noreturn]] void reportNondeterminism(const Database& db, const std::string& id, const Earlier& earlier,
                                       const std::string& computed) {
  throw NondeterminismError(
      db.file().string() + ": run " + id +
          ": NONDETERMINISM: the same scenario, seed and build gave another result; stored " +
          earlier.stateHash + " (" + earlier.started + ", " + earlier.cpu + ", " + earlier.isa +
          ", threads " + std::to_string(earlier.threads) + "), now " + computed +
          "; the stored run is kept. This is a bug or broken hardware: `morula explain` finds where they "
          "part",
      id, earlier.stateHash, computed);
}

}  // namespace

Store Store::openForWriting(const std::filesystem::path& file, Options options) {
  Database db(file, Database::Mode::create, options.patience);
  if (db.readOnly())
    throw StoreError(file.string() +
                     ": the file is not writable; change its permissions or give another file");
  migrate(db);
  configure(db);
  return Store(std::move(db));
}

Store Store::temporary() {
  Database db("the temporary database", Database::Mode::temporary, std::chrono::seconds(1));
  migrate(db);
  configure(db);
  return Store(std::move(db));
}

Store Store::openForReading(const std::filesystem::path& file, Options options) {
  Database db(file, Database::Mode::existing, options.patience);
  requireCurrentSchema(db);
  return Store(std::move(db));
}

std::string Store::begin(const RunRecord& record) {
  const std::string id = runId(record);
  const Attempt& attempt = attempts_[id] = {record, utcNow()};
  if (recorded_) deleteResults(*recorded_, id);
  Transaction transaction(db_);
  if (const auto earlier = findEarlier(db_, id)) {
    if (earlier->status == name(RunStatus::done)) return id;
    if (checkpointStep(id)) {
      restartRun(db_, id, attempt.started);
      transaction.commit();
      return id;
    }
    deleteRun(db_, id);
  }
  insertRun(db_, id, attempt.record, attempt.started, nullptr);
  transaction.commit();
  return id;
}

void Store::record(const std::string& id, const RunResults& records) {
  if (!recorded_) {
    recorded_.emplace("the records of a run that goes on", Database::Mode::temporary,
                      std::chrono::seconds(1));
    migrate(*recorded_);
  }
  recorded_->execute("BEGIN");
  insertRecords(*recorded_, id, records);
  recorded_->execute("COMMIT");
}

void Store::takeOver(const std::string& id, std::optional<std::uint64_t> after) {
  if (!recorded_) return;
  // All rows but those of hashes go by their sample's time.
  Statement last(db_, "SELECT max(time) FROM sample WHERE run_id = ? AND step <= ?");
  const double time = after && last.start(id, *after).next() && !last.isNull(0) ? last.real(0) : -1;
  const std::int64_t step = after ? static_cast<std::int64_t>(*after) : -1;
  for (const char* table : {"sample", "cell_sample", "contact", "measure", "mesh_sample"})
    copyRows(*recorded_, db_, table, "run_id = ? AND time > ?", id, time);
  for (const char* table : {"step_hash", "cell_hash"})
    copyRows(*recorded_, db_, table, "run_id = ? AND step > ?", id, step);
}

void Store::finish(const std::string& id, const RunEnd& end, const RunResults& results) {
  const auto attempt = attempts_.find(id);
  MORULA_CHECK(attempt != attempts_.end(), "a run is begun before it is finished");
  MORULA_CHECK(end.status != RunStatus::running, "a finished run does not run");
  MORULA_CHECK(end.status != RunStatus::done || end.stateHash, "a run that is done has a state hash");
  Transaction transaction(db_);
  if (const auto earlier = findEarlier(db_, id)) {
    if (earlier->status == name(RunStatus::done)) {
      // Half a run says nothing against a whole one.
      if (end.status == RunStatus::killed || end.want != Want::nothing) return;
      const std::string computed =
          end.status == RunStatus::done ? end.stateHash->text() : "failed: " + end.failure;
      if (earlier->stateHash != computed) reportNondeterminism(db_, id, *earlier, computed);
    }
    if (end.status == RunStatus::killed) {
      endRun(db_, id, end);
      if (checkpointStep(id).value_or(0) <= end.steps) {  // else the file knows more of this run already
        deleteResults(db_, id);
        takeOver(id);
        insertResults(db_, id, results);
      }
      transaction.commit();
      attempts_.erase(attempt);
      return;
    }
    deleteRun(db_, id);
  }
  insertRun(db_, id, attempt->second.record, attempt->second.started, &end);
  takeOver(id);
  insertResults(db_, id, results);
  transaction.commit();
  attempts_.erase(attempt);
}

void Store::addChecks(const std::string& id, const std::vector<CheckResult>& checks) {
  Transaction transaction(db_);
  if (!findEarlier(db_, id)) throw StoreError(db_.file().string() + ": no run " + id + " to add checks to");
  Statement forget(db_, "DELETE FROM check_result WHERE run_id = ? AND kind = ?");
  for (const CheckResult& check : checks) forget.run(id, check.kind);
  insertChecks(db_, id, checks);
  transaction.commit();
}

void Store::putBulletSamples(const std::string& id, const std::string& baseline,
                             const std::vector<Sample>& samples) {
  Transaction transaction(db_);
  if (!findEarlier(db_, id)) throw StoreError(db_.file().string() + ": no run " + id + " to add samples to");
  Statement(db_, "DELETE FROM bullet_sample WHERE run_id = ?").run(id);
  insertBulletSamples(db_, id, baseline, samples);
  transaction.commit();
}

void Store::copyRun(const std::string& id, const std::filesystem::path& file) {
  Statement(db_, "VACUUM INTO ?").run(file.string());
  Database copy(file, Database::Mode::existing, std::chrono::seconds(1));
  configure(copy);
  for (const char* table : {"replicate", "condition_key", "condition", "level", "axis", "study"})
    copy.execute(std::string("DROP TABLE IF EXISTS ") + table);  // of all runs of a study together
  Statement(copy, "DELETE FROM run WHERE run_id <> ?").run(id);
  copy.execute("DELETE FROM document WHERE hash NOT IN (SELECT hash FROM run_document)");
  copy.execute("DELETE FROM checkpoint");
  copy.execute("VACUUM");
}

}  // namespace morula

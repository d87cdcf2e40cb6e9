#include "study_store/task_file.h"

#include "database/store_error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "golden/result_state.h"
#include "store/result_file.h"
#include "store/rows.h"
#include "store/seal.h"

namespace morula {
namespace {

// A task's file has some thirty tables, most of them empty or short, so pages are small. Rows of cells do not fit into
// smaller ones.
constexpr int pageSize = 1024;
constexpr std::uint64_t maxTaskBytes = std::uint64_t{16} << 30;

TaskStatus statusOf(RunStatus run) {
  return run == RunStatus::done     ? TaskStatus::done
         : run == RunStatus::failed ? TaskStatus::failed
                                    : TaskStatus::missing;
}

TaskRow taskOf(Database& db) {
  if (db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = 'task'") != 1 ||
      db.integer("SELECT count(*) FROM task") != 1)
    throw StoreError(db.file().string() + ": a database of Morula's, but not of one task of a study");
  Statement s(db, sqlTable<TaskRow>().select(db));
  s.next();
  const auto task = s.row<TaskRow>();
  if (task.status != TaskStatus::done && task.status != TaskStatus::failed) s.refuse(4, "needs done or failed");
  return task;
}

}  // namespace

const std::string& emptyTaskFile() {
  static const std::string bytes = [] {
    Database db = Database::inMemory("a task's database");
    db.execute("PRAGMA page_size = " + std::to_string(pageSize));
    // Comments are half of the tables' text, and each task's file would repeat them: `.schema` of the merged file has
    // them.
    makeTables(db, false);
    makeTaskTables(db, false);
    db.execute("VACUUM");
    return db.bytes();
  }();
  return bytes;
}

std::string taskFileBytes(TaskOutcome o) {
  Database db = Database::inMemory("a task's database", emptyTaskFile());
  db.execute("BEGIN");
  const std::string id = runId(o.record);
  insertRun(db, id, o.record, o.timing.started, &o.end);
  insertResults(db, id, o.results);
  Statement value(db, sqlTable<ResultRow>().insert());
  for (const ResultRow& row : o.values) value.run(id, row);
  sealRun(db, id);
  o.task.status = statusOf(o.end.status);
  o.task.runId = id;
  o.task.resultHash = resultHash(db, id).text();
  Statement(db, sqlTable<TaskRow>().insert()).run(o.task);
  Statement(db, sqlTable<TimingRow>().insert()).run(o.task.id, o.timing);
  db.execute("COMMIT");
  return db.bytes();
}

TaskFile::TaskFile(const std::filesystem::path& file)
    : store_([&] {
        Database db = Database::inMemory(file, readFile(file, maxTaskBytes));
        requireTables(db);
        return Store(std::move(db));
      }()),
      task_(taskOf(store_.db_)),
      run_(store_.find(task_.runId)) {}

TimingRow TaskFile::timing() {
  auto rows = rowsOf<TimingRow>(db(), "", task_.id);
  return rows.empty() ? TimingRow() : std::move(rows.front());
}

std::string TaskFile::buildId() { return morula::buildId(run_.record.build); }

std::string TaskFile::resolved() {
  Statement s(db(),
              "SELECT content FROM run_document JOIN document USING (hash) WHERE run_id = ? AND role = 'resolved'");
  return s.start(run_.id).next() ? s.text(0) : "";
}

std::string TaskFile::whyInsane() { return morula::whyInsane(store_.checks(run_.id)); }

std::string TaskFile::whatIsWrong() {
  Statement integrity(db(), "PRAGMA integrity_check(1)");
  if (integrity.next() && integrity.text(0) != "ok") return "the database is damaged: " + integrity.text(0);
  if (run_.id != task_.runId) return "the file's task names run " + task_.runId + ", but its run is " + run_.id;
  if (task_.status != statusOf(run_.status))
    return std::string("the file's task is ") + nameOf(task_.status) + ", and its run " + nameOf(run_.status);
  if (const auto changed = store_.changedRecord(run_.id); !changed.empty()) {
    const ValueDifference& first = changed.front();
    return "the record of the file's run was changed: " + first.table + ", " + first.row + ": " + first.stored +
           " is stored, and " + first.recomputed + " follows";
  }
  if (const std::string hash = resultHash(db(), run_.id).text(); hash != task_.resultHash)
    return "the results in the file were changed: their hash is " + hash + ", and " + task_.resultHash + " was stored";
  return "";
}

bool looksWhole(const std::filesystem::path& file) {
  const std::string head = readHead(file, 100);
  if (head.size() < 100 || !head.starts_with(std::string_view("SQLite format 3\0", 16))) return false;
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | static_cast<unsigned char>(head[at + i]);
    return value;
  };
  const std::uint64_t page = number(16, 2) == 1 ? 65536 : number(16, 2);
  return page * number(28, 4) == fileSize(file);
}

}  // namespace morula

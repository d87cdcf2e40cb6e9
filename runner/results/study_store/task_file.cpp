#include "study_store/task_file.h"

#include "database/schema.h"
#include "database/store_error.h"
#include "files/folders.h"
#include "files/read_file.h"
#include "store/rows.h"

namespace morula {

namespace {

// A task's file has some thirty tables, most of them empty or short, so small pages; rows of cells do not fit into smaller ones.
constexpr int pageSize = 1024;
constexpr std::uint64_t maxTaskBytes = std::uint64_t{16} << 30;

TaskRow taskOf(Database& db) {
  if (db.integer("SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = 'task'") != 1 ||
      db.integer("SELECT count(*) FROM task") != 1)
    throw StoreError(db.file().string() + ": a database of Morula's, but not of one task of a study");
  Statement s(db,
              "SELECT task_id, number, condition_id, seed, status, reason, run_id, result_hash FROM task");
  s.next();
  TaskRow task{.id = s.line(0),
               .number = s.natural(1),
               .condition = s.natural(2),
               .seed = s.bits(3),
               .status = s.line(4),
               .reason = s.text(5),
               .runId = s.line(6),
               .resultHash = s.line(7)};
  if (task.status != "done" && task.status != "failed") s.refuse(4, "needs done or failed");
  return task;
}

}  // namespace

namespace {

/// Comments make up half of the tables' text, which each task's file would repeat: `.schema` of the merged file has them.
void dropComments(Database& db) {
  std::vector<std::pair<std::string, std::string>> tables;
  Statement s(db, "SELECT name, sql FROM sqlite_schema WHERE sql IS NOT NULL");
  while (s.next()) tables.emplace_back(s.text(0), s.text(1));
  db.execute("PRAGMA writable_schema = ON");
  Statement change(db, "UPDATE sqlite_schema SET sql = ? WHERE name = ?");
  for (auto& [name, sql] : tables) {
    std::string bare;
    for (std::size_t begin = 0; begin < sql.size();) {
      const std::size_t end = std::min(sql.find('\n', begin), sql.size());
      std::string line = sql.substr(begin, end - begin);
      line.resize(std::min(line.find("--"), line.size()));
      const std::size_t first = line.find_first_not_of(' '), last = line.find_last_not_of(' ');
      if (first != line.npos) bare += (bare.empty() ? "" : " ") + line.substr(first, last - first + 1);
      begin = end + 1;
    }
    change.run(bare, name);
  }
  db.execute("PRAGMA writable_schema = RESET");
}

}  // namespace

const std::string& emptyTaskFile() {
  static const std::string bytes = [] {
    Database db = Database::inMemory("a task's database");
    db.execute("PRAGMA page_size = " + std::to_string(pageSize));
    migrate(db);
    makeTaskTables(db);
    dropComments(db);
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
  insertResults(db, id, o.values);
  o.task.status = name(o.end.status);
  o.task.runId = id;
  o.task.resultHash = resultHash(db, id).text();
  insertTask(db, o.task);
  insertTiming(db, o.task.id, o.timing);
  db.execute("COMMIT");
  return db.bytes();
}

TaskFile::TaskFile(const std::filesystem::path& file)
    : store_([&] {
        Database db = Database::inMemory(file, readFile(file, maxTaskBytes));
        requireCurrentSchema(db);
        return Store(std::move(db));
      }()),
      task_(taskOf(store_.db_)),
      run_(store_.find(task_.runId)) {}

TimingRow TaskFile::timing() {
  Statement s(
      db(),
      "SELECT started, ended, cpu_seconds, max_memory, host, cpu, kernel, cpu_features, fp_environment, "
      "isa, threads, command, binary_hash FROM timing WHERE task_id = ?");
  if (!s.start(task_.id).next()) return {};
  return {s.line(0),
          s.line(1),
          s.real(2),
          s.natural(3),
          s.line(4),
          s.line(5),
          s.line(6),
          s.line(7),
          s.line(8),
          s.line(9),
          static_cast<int>(s.natural(10)),
          s.text(11),
          s.line(12)};
}

std::string TaskFile::buildId() { return morula::buildId(run_.record.build); }

std::string TaskFile::resolved() {
  Statement s(
      db(),
      "SELECT content FROM run_document JOIN document USING (hash) WHERE run_id = ? AND role = 'resolved'");
  return s.start(run_.id).next() ? s.text(0) : "";
}

std::uint64_t TaskFile::insaneChecks() {
  return static_cast<std::uint64_t>(
      db().integer("SELECT count(*) FROM check_result WHERE kind = 'sanity' AND NOT passed"));
}

std::string TaskFile::whatIsWrong() {
  Statement integrity(db(), "PRAGMA integrity_check(1)");
  if (integrity.next() && integrity.text(0) != "ok") return "the database is damaged: " + integrity.text(0);
  if (run_.id != task_.runId) return "its task names run " + task_.runId + ", and its run is " + run_.id;
  if (task_.status != name(run_.status))
    return "its task is " + task_.status + ", and its run " + name(run_.status);
  if (const auto changed = store_.changedRecord(run_.id); !changed.empty()) {
    const ValueDifference& first = changed.front();
    return "the record of its run was changed: " + first.table + ", " + first.row + ": " + first.stored +
           " is stored, and " + first.recomputed + " follows";
  }
  if (const std::string hash = resultHash(db(), run_.id).text(); hash != task_.resultHash)
    return "its results were changed: their hash is " + hash + ", and " + task_.resultHash + " was stored";
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

#include "store/result_file.h"

#include <algorithm>

#include "database/store_error.h"
#include "store/run_tables.h"

namespace morula {
namespace {

[[noreturn]] void refuseVersion(const Database& db, const std::string& why) {
  throw StoreError(db.file().string() + ": written by another version of Morula (" + why +
                   "); use the program that wrote it, or give another file");
}

/// Returns true if the file is empty. Throws StoreError unless it is empty or Morula's and of this version.
bool isEmpty(Database& db) {
  // A single statement sees the file at one moment; another process may be making the tables.
  Statement s(
      db,
      "SELECT (SELECT application_id FROM pragma_application_id), (SELECT user_version FROM pragma_user_version), "
      "(SELECT count(*) FROM sqlite_schema)");
  s.next();
  const auto id = s.integer(0), version = s.integer(1);
  if (id == 0 && version == 0 && s.integer(2) == 0) return true;
  if (id != applicationId)
    throw StoreError(db.file().string() + ": a database, but not one of Morula's (application_id " +
                     std::to_string(id) + "); give another file");
  if (version != schemaVersion)
    refuseVersion(
        db, "database version " + std::to_string(version) + ", this program's is " + std::to_string(schemaVersion));
  return false;
}

/// Returns the statements that add columns of measures which the file's tables lack; "" if none lack. Throws StoreError
/// if another column lacks.
std::string lackingMeasures(Database& db) {
  std::string sql;
  for (const SqlTable* t : runTables()) {
    const std::vector<std::string> there = columnNames(db, t->info.name);
    std::vector<std::string> unknown = there;
    std::string lacks;
    for (const auto* columns : {&t->context, &t->own})
      for (const SqlColumn& c : *columns) {
        std::erase(unknown, c.name);
        if (std::ranges::find(there, c.name) != there.end()) continue;
        lacks = c.name;
        if (!c.isMeasure) refuseVersion(db, "its table " + std::string(t->info.name) + " has no column " + c.name);
        sql += "ALTER TABLE " + sqlName(t->info.name) + " ADD COLUMN " + sqlName(c.name) + " " + c.type + ";\n";
      }
    // An older program's tables lack measures, and a newer program's have more. A table with both has a renamed column.
    if (!lacks.empty() && !unknown.empty())
      refuseVersion(db, "its table " + std::string(t->info.name) + " has a column '" + unknown.front() +
                            "', which this program does not know, and no column " + lacks);
  }
  return sql;
}

std::string lacking(Database& db, bool withComments) {
  if (!isEmpty(db)) return lackingMeasures(db);
  std::string sql;
  for (const SqlTable* t : runTables()) sql += t->create(withComments) + ";\n";
  return sql;
}

}  // namespace

void configure(Database& db) {
  db.execute("PRAGMA foreign_keys = ON");
  db.execute("PRAGMA synchronous = FULL");
  db.execute("PRAGMA cache_size = -65536");  // 64 MiB: a large run's rows need not be written twice
  // The rollback journal is SQLite's own default. Write-ahead logs lose data with several writers before
  // SQLite 3.51.3 and do not work on network disks, so a file that was switched to them is switched back.
  if (!db.readOnly()) db.execute("PRAGMA journal_mode = DELETE");
}

void makeTables(Database& db, bool withComments) {
  if (lacking(db, withComments).empty()) return;
  if (db.readOnly())
    throw StoreError(db.file().string() + ": the file is not writable; change its permissions or give another file");
  Transaction transaction(db);
  db.execute(lacking(db, withComments));  // evaluated again, since another process may have made the tables
  db.execute("PRAGMA application_id = " + std::to_string(applicationId));
  db.execute("PRAGMA user_version = " + std::to_string(schemaVersion));
  transaction.commit();
}

void requireTables(Database& db) {
  if (isEmpty(db)) throw StoreError(db.file().string() + ": the file is empty; a database of results is expected");
  lackingMeasures(db);
}

}  // namespace morula

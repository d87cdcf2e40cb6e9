#include "store/seal.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "database/store_error.h"
#include "store/run_tables.h"

namespace morula {
namespace {

const std::string ofRun = "run_id = ?";

/// A table of a run, or of a study whose rows belong to its runs.
struct RunTable {
  std::string name;
  TablePart part;
};

/// Returns the tables with rows of runs. `result`, which studies add to the file, comes last.
std::vector<RunTable> tablesOf(Database& db) {
  std::vector<RunTable> tables;
  for (const SqlTable* t : runTables())
    if (t->info.part != TablePart::seal && t != &sqlTable<StoredText>()) tables.push_back({t->info.name, t->info.part});
  Statement result(db, "SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = 'result'");
  if (result.next()) tables.push_back({"result", TablePart::study});
  return tables;
}

void store(Database& db, const std::string& id, const std::string& table, const RowDigest& digest) {
  static const std::string insert =
      sqlTable<SealedTable>().insert() + " ON CONFLICT DO UPDATE SET rows = excluded.rows, digest = excluded.digest";
  Statement(db, insert).run(id, SealedTable{table, digest});
}

[[noreturn]] void refuse(Database& db, const std::string& id, const std::string& what) {
  throw StoreError(fmt::format("{}: {}{}; restore the file from a copy, or write it again", db.file().string(),
                               id.empty() ? "" : "run " + id + ": ", what));
}

}  // namespace

const char* recordColumn(const SqlTable& table) {
  return std::string_view(table.info.key).starts_with("run_id, time") ? "time" : "step";
}

void sealRun(Database& db, const std::string& id, bool (*takes)(TablePart)) {
  for (const RunTable& t : tablesOf(db))
    if (!takes || takes(t.part)) store(db, id, t.name, digestRows(db, t.name, ofRun, id));
}

void extendSeal(Database& db, const std::string& id, const RecordedUntil& until) {
  std::vector<SealedTable> sealed = rowsOf<SealedTable>(db, "", id);
  for (const SqlTable* t : runTables()) {
    if (!growsDuringRun(t->info.part)) continue;
    const auto before = std::ranges::find(sealed, t->info.name, &SealedTable::table);
    MORULA_CHECK(before != sealed.end(), "a run is sealed before records join it");
    const bool byTime = recordColumn(*t) == std::string_view("time");
    const std::string where = ofRun + " AND " + recordColumn(*t) + " > ?";
    before->digest += byTime ? digestRows(db, t->info.name, where, id, until.time)
                             : digestRows(db, t->info.name, where, id, until.step);
    store(db, id, t->info.name, before->digest);
  }
}

namespace {

void compare(Database& db, const std::string& id, const std::string& table, const RowDigest& found,
             const RowDigest& stored) {
  if (found == stored) return;
  const std::string counts =
      found.rows == stored.rows ? "" : fmt::format("; there are {}, and {} were stored", found.rows, stored.rows);
  refuse(db, id,
         fmt::format("rows of its table {} do not match the digest that was stored with them{}", table, counts));
}

}  // namespace

void requireAllSealed(Database& db, bool (*takes)(TablePart)) {
  for (const RunTable& t : tablesOf(db)) {
    if (!takes(t.part)) continue;
    auto found = RowDigester(db, t.name, "").digestsBy("run_id");
    Statement sealed(db, "SELECT run_id, rows, digest FROM row_digest WHERE name = ?");
    std::size_t runs = 0;
    for (sealed.start(t.name); sealed.next(); ++runs) {
      const std::string id = sealed.text(0);
      const auto hash = readHash(sealed.line(2));
      if (!hash) sealed.refuse(2, "needs 32 hexadecimal digits");
      compare(db, id, t.name, found[id], {sealed.bits(1), *hash});
    }
    // A run whose digest is missing is in `found` alone.
    if (found.size() != runs) refuse(db, "", "rows of the table " + t.name + " have no digest in row_digest");
  }
}

void requireSealed(Database& db, const std::string& id, bool (*takes)(TablePart)) {
  const std::vector<SealedTable> sealed = rowsOf<SealedTable>(db, "", id);
  for (const RunTable& t : tablesOf(db)) {
    if (takes && !takes(t.part)) continue;
    const auto stored = std::ranges::find(sealed, t.name, &SealedTable::table);
    if (stored == sealed.end()) refuse(db, id, "its table " + t.name + " has no digest in row_digest");
    compare(db, id, t.name, digestRows(db, t.name, ofRun, id), stored->digest);
  }
}

}  // namespace morula

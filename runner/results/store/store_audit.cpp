// Whether what a file holds is what was once stored.
#include <set>

#include "base/hash.h"
#include "database/store_error.h"
#include "store/store.h"

namespace morula {

void Store::requireIntact() {
  static std::set<std::filesystem::path> intact;  // by this process; looking takes as long as reading the file does
  if (intact.contains(file())) return;
  Statement integrity(db_, "PRAGMA integrity_check(1)");
  const std::string found = integrity.next() ? integrity.text(0) : "ok";
  if (found != "ok")
    throw StoreError(file().string() + ": the database is damaged: " + found.substr(found.find('\n') + 1) +
                     "; restore the file from a copy, or run the scenario again");
  intact.insert(file());
}

std::vector<ValueDifference> Store::changedRecord(const std::string& id) {
  std::vector<ValueDifference> changed;
  Statement s(db_,
              "SELECT d.number, d.role, d.hash, t.content FROM run_document d LEFT JOIN document t USING (hash) "
              "WHERE run_id = ? ORDER BY d.number");
  for (s.start(id); s.next();) {
    const std::string row = "number " + std::to_string(s.integer(0)) + ", role " + s.text(1);
    if (s.isNull(3)) {
      changed.push_back({"document", row, "", s.text(2), "no such row"});
      continue;
    }
    const std::string hash = Hasher().add(s.text(3)).digest().text();
    if (hash != s.text(2)) changed.push_back({"document", row, "content", s.text(2), hash});
  }
  const StoredRun run = find(id);
  const std::string build = buildId(run.record.build), own = runId(run.record);
  Statement row(db_, "SELECT build_id FROM run WHERE run_id = ?");
  row.start(id).next();
  if (row.text(0) != build) changed.push_back({"run", "run_id " + id, "build_id", row.text(0), build});
  if (own != id) changed.push_back({"run", "run_id " + id, "run_id", id, own});
  return changed;
}

std::vector<ValueDifference> Store::lostCells(const StoredRun& run) {
  std::vector<ValueDifference> lost;
  const auto add = [&](const char* which, const char* column, const char* stored) {
    Statement s(db_, std::string("SELECT path FROM cell c WHERE run_id = ? AND ") + which + " ORDER BY path LIMIT 1");
    if (s.start(run.id).next()) lost.push_back({"cell", "path " + s.text(0), column, stored, "no such row"});
  };
  add("parent IS NOT NULL AND NOT EXISTS (SELECT 1 FROM cell m WHERE m.run_id = c.run_id AND m.path = c.parent AND "
      "m.fate = 'divided')",
      "parent", "a mother that divided");
  add("fate = 'divided' AND (SELECT count(*) FROM cell d WHERE d.run_id = c.run_id AND d.path IN (c.path || 'A', "
      "c.path || 'B')) < 2",
      "fate", "divided into two daughters");
  if (run.status != RunStatus::done) return lost;
  Statement alive(db_, "SELECT count(*) FROM cell WHERE run_id = ? AND fate = 'alive'");
  alive.start(run.id).next();
  if (alive.natural(0) != run.cells)
    lost.push_back({"run", "run_id " + run.id, "cells", std::to_string(run.cells), std::to_string(alive.natural(0))});
  return lost;
}

std::vector<TableDifference> Store::compareResults(const std::string& id, Store& again, const std::string& idAgain) {
  return compareTables(db_, id, again.db_, idAgain);
}

std::vector<TableContents> Store::contents(const std::vector<const SqlTable*>& known, const std::string& id) {
  return contentsOf(db_, id, known);
}

}  // namespace morula

// Whether what a file holds is what was once stored.
#include "base/hash.h"
#include "store/store.h"

namespace morula {

std::vector<ValueDifference> Store::changedRecord(const std::string& id) {
  std::vector<ValueDifference> changed;
  Statement s(
      db_,
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

std::vector<TableDifference> Store::compareResults(const std::string& id, Store& again,
                                                   const std::string& idAgain) {
  return compareTables(db_, id, again.db_, idAgain);
}

std::vector<TableContents> Store::contents(const std::vector<const Table*>& known, const std::string& id) {
  return contentsOf(db_, id, known);
}

}  // namespace morula

#pragma once
// Renews digests of rows that tests have changed, so that tests reach the other checks of readers.
#include <string>
#include <vector>

#include "base/error.h"
#include "database/database.h"
#include "database/row_digest.h"
#include "store/seal.h"

namespace morula::test {

inline Database opened(const std::string& file) { return {file, Database::Mode::existing, std::chrono::seconds(5)}; }

/// Renews the digests of all rows, like an attacker who knows of digests.
inline void reseal(const std::string& file) {
  try {
    Database db = opened(file);
    std::vector<std::string> runs, tables;
    for (Statement ids(db, "SELECT run_id FROM run"); ids.next();) runs.push_back(ids.text(0));
    for (const std::string& id : runs) sealRun(db, id);
    if (db.integer("SELECT count(*) FROM sqlite_schema WHERE name = 'study_digest'") == 0) return;
    for (Statement names(db, "SELECT name FROM study_digest"); names.next();) tables.push_back(names.text(0));
    for (const std::string& table : tables) {
      const RowDigest digest = digestRows(db, table, "");
      Statement(db, "UPDATE study_digest SET rows = ?, digest = ? WHERE name = ?").run(digest.rows, digest.sum, table);
    }
  } catch (const FileError&) {}  // other checks report such damage
}

}  // namespace morula::test

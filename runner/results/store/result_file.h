#pragma once
// The identity and version of a file of results, and its tables. store/README.md describes them for readers.
#include "database/database.h"

namespace morula {

/// "Mrla", which marks Morula's databases (SQLite's `PRAGMA application_id`, `file` shows it).
inline constexpr int applicationId = 0x4d726c61;
/// The version of the tables (`PRAGMA user_version`). Files of this version whose tables lack a column count as another
/// version.
inline constexpr int schemaVersion = 9;

/// Sets up a connection: rollback journal, every commit on the disk, foreign keys checked.
void configure(Database& db);

/// Makes the tables of a run in an empty file, and adds missing columns of measures to a file's tables, in one
/// transaction. Throws StoreError for a database of another program or another version. `withComments`: puts comments
/// on the columns, for `.schema`.
void makeTables(Database& db, bool withComments = true);

/// Throws StoreError if the tables are not usable or the file is empty. Writes nothing.
void requireTables(Database& db);

}  // namespace morula

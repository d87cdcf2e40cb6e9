#pragma once
// Whose a file is and with which tables. store/README.md describes them for readers.
#include "database/database.h"

namespace morula {

/// "Mrla": tells Morula's databases from all others (SQLite's `PRAGMA application_id`, `file` shows it).
inline constexpr int applicationId = 0x4d726c61;
/// The version of the tables (`PRAGMA user_version`). Files of this version whose tables lack a column are of another,
/// too.
inline constexpr int schemaVersion = 9;

/// Settings of one connection: rollback journal, every commit on the disk, foreign keys checked.
void configure(Database& db);

/// Makes the tables of a run in an empty file, and columns for measures that a file's tables lack, in one transaction.
/// Throws StoreError for a database of another program or another version. `withComments`: on the columns, for
/// `.schema`.
void makeTables(Database& db, bool withComments = true);

/// Checks the tables without writing. Throws StoreError also for an empty file.
void requireTables(Database& db);

}  // namespace morula

#pragma once
// The tables, and how a file shows whose it is and how old. store/README.md describes them for readers.
#include "database/database.h"

namespace morula {

/// "Mrla": tells Morula's databases from all others (SQLite's `PRAGMA application_id`, `file` shows it).
inline constexpr int applicationId = 0x4d726c61;
/// The version that this program writes (`PRAGMA user_version`).
int schemaVersion();

/// Settings of one connection: rollback journal, every commit on the disk, foreign keys checked.
void configure(Database& db);

/// Makes the tables in an empty file and brings an older file up to date, in one transaction. Throws
/// StoreError for a database of another program or from a newer Morula.
void migrate(Database& db);

/// The same checks without writing: throws StoreError also for an empty or an older file.
void requireCurrentSchema(Database& db);

}  // namespace morula

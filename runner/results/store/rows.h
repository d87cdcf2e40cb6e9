#pragma once
// Stores rows from plain data. Each function writes into its caller's transaction.
#include "database/record_table.h"
#include "store/records.h"

namespace morula {

/// Inserts the row `run` and the run's documents. Without `end` the status is running.
void insertRun(Database& db, const std::string& id, const RunRecord& record, const std::string& started,
               const RunEnd* end);
/// Sets an unfinished run to running again and deletes its results but for its records.
void restartRun(Database& db, const std::string& id, const std::string& started);
/// Stores the end of a run in its row.
void endRun(Database& db, const std::string& id, const RunEnd& end);
void insertResults(Database& db, const std::string& id, const RunResults& results);
/// Deletes the run's rows in tables of these parts, by default in all tables of results.
void deleteRows(
    Database& db, const std::string& id,
    bool (*takes)(TablePart) = [](TablePart part) {
      return isResult(part) || part == TablePart::against || part == TablePart::bullet;
    });
/// Stores samples and hashes of steps after `after`, or all of them without `after`.
void insertRecords(Database& db, const std::string& id, const RunResults& results,
                   std::optional<std::uint64_t> after = {});
/// Stores the measures of Bullet's cells that can be seen from outside.
void insertBulletSamples(Database& db, const std::string& id, const std::string& baseline,
                         const std::vector<Sample>& samples);
/// Stores the checkpoint of a run in place of its last one.
void replaceCheckpoint(Database& db, const std::string& id, const Checkpoint& checkpoint);
void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks);

}  // namespace morula

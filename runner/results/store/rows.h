#pragma once
// Rows out of plain data. Each function writes into a transaction of its caller's.
#include "database/record_table.h"
#include "store/records.h"

namespace morula {

/// The row `run` and the run's documents; without an end its status is running.
void insertRun(Database& db, const std::string& id, const RunRecord& record, const std::string& started,
               const RunEnd* end);
/// The row `run` is there, and the run has not finished: it runs again, and only its records stay.
void restartRun(Database& db, const std::string& id, const std::string& started);
/// The row `run` is there and running: how it ended.
void endRun(Database& db, const std::string& id, const RunEnd& end);
void insertResults(Database& db, const std::string& id, const RunResults& results);
/// All rows of the run in tables of these parts: of all that results are made of.
void deleteRows(
    Database& db, const std::string& id,
    bool (*takes)(TablePart) = [](TablePart part) { return isResult(part) || part == TablePart::bullet; });
/// Stores samples and hashes of steps after `after`, or all of them without `after`.
void insertRecords(Database& db, const std::string& id, const RunResults& results,
                   std::optional<std::uint64_t> after = {});
/// Stores the measures of Bullet's cells that can be seen from outside.
void insertBulletSamples(Database& db, const std::string& id, const std::string& baseline,
                         const std::vector<Sample>& samples);
void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks);

}  // namespace morula

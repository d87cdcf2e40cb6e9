#pragma once
// Rows out of plain data. Each function writes into a transaction of its caller's.
#include "store/database.h"
#include "store/records.h"

namespace morula {

/// The row `run` and the run's documents; without an end its status is running.
void insertRun(Database& db, const std::string& id, const RunRecord& record, const std::string& started,
               const RunEnd* end);
void insertResults(Database& db, const std::string& id, const RunResults& results);
void insertChecks(Database& db, const std::string& id, const std::vector<CheckResult>& checks);

}  // namespace morula

#pragma once
// The digests of a run's rows, stored beside them: they prove that rows are read as they were written.
#include <optional>
#include <string>
#include <vector>

#include "database/record_table.h"
#include "database/row_digest.h"

namespace morula {

/// A row of the table `row_digest`.
struct SealedTable {
  std::string table;
  RowDigest digest;
};
template <>
inline constexpr TableInfo tableInfo<SealedTable> = {
    .name = "row_digest",
    .part = TablePart::seal,
    .context = "run_id",
    .key = "run_id, name",
    .why = "always: every verb that reads a run's rows holds them against these"};
template <IsA<SealedTable> T>
void listFields(T& sealed, auto&& field) {
  auto& [table, digest] = sealed;
  auto& [rows, sum] = digest;
  field({"name", "of a table that holds rows of the run"}, table);
  field({"rows"}, rows);
  field({"digest", "sum modulo 2^128 of the XXH3-128 of each row"}, sum);
}

/// Stores new digests of the run's rows that the file holds, for tables of these parts. `takes` null: for all tables.
void sealRun(Database& db, const std::string& id, bool (*takes)(TablePart) = nullptr);

/// A time and a step. Records after them have joined the records of a sealed run.
struct RecordedUntil {
  double time = -1;        // [time] of the last sample
  std::int64_t step = -1;  // step of the last hash
};
/// Adds the rows after `until` to the digests of samples and hashes, without reading rows that were stored earlier.
void extendSeal(Database& db, const std::string& id, const RecordedUntil& until);

/// Throws StoreError unless the run's rows are as stored, in tables of these parts and the table `result` of a study.
/// `takes` null: in all tables.
void requireSealed(Database& db, const std::string& id, bool (*takes)(TablePart) = nullptr);

/// Checks the digests of all runs of a file, in one pass over each table.
void requireAllSealed(Database& db, bool (*takes)(TablePart));

/// Returns the column that decides whether a row of samples or hashes is after `until`: "time" or "step".
const char* recordColumn(const SqlTable& table);

}  // namespace morula

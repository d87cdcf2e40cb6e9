#pragma once
// The digests of a run's rows, kept beside them: what is read for an answer is what was written.
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

/// Takes the digests of the run's tables of these parts anew from the rows that the file holds; `takes` null: of all
/// tables.
void sealRun(Database& db, const std::string& id, bool (*takes)(TablePart) = nullptr);

/// Records after this time and step have joined those of a run that is sealed.
struct RecordedUntil {
  double time = -1;        // [time] of the last sample
  std::int64_t step = -1;  // of the last hash
};
/// Adds the rows after `until` to the digests of samples and hashes, so that rows that were stored earlier are not read
/// again.
void extendSeal(Database& db, const std::string& id, const RecordedUntil& until);

/// Throws StoreError unless the rows of the run's tables of these parts, and of the table `result` of a study, are
/// those that were stored. `takes` null: of all tables.
void requireSealed(Database& db, const std::string& id, bool (*takes)(TablePart) = nullptr);

/// Checks the digests of all runs of a file, in one pass over each table.
void requireAllSealed(Database& db, bool (*takes)(TablePart));

/// The condition for rows of samples and hashes after `until`, whose one parameter is `until.time` or `until.step`:
/// "time" or "step" is the column that decides.
const char* recordColumn(const SqlTable& table);

}  // namespace morula

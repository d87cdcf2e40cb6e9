#pragma once
// A digest of the rows of a table, which tells whether the rows that are read are those that were written.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/hash.h"
#include "database/database.h"

namespace morula {

/// The number of rows, and the sum modulo 2^128 of a hash of each. The order of rows does not count, so rows that are
/// added later are added to the digest.
struct RowDigest {
  std::uint64_t rows = 0;
  Hash sum;

  RowDigest& operator+=(const RowDigest& more);
  friend bool operator==(const RowDigest&, const RowDigest&) = default;
};

/// Digests the rows of a table for which `where` holds ("run_id = ?"), whose parameters are `values`. The hash of a row
/// is XXH3-128 over the names, types and values of those of its columns that are not NULL: a column that joins a table
/// later changes no digest, and one that is renamed does. Throws StoreError if the table or a column of `where` is
/// missing.
template <class... Values>
RowDigest digestRows(Database& db, const std::string& table, const std::string& where, const Values&... values);

/// The statement that digestRows runs, and what it makes of its rows.
class RowDigester {
 public:
  RowDigester(Database& db, const std::string& table, const std::string& where);
  Statement& rows() { return rows_; }
  /// Takes all rows of the statement, which has been started.
  RowDigest digest();
  /// Returns the digest for each value of a column of texts by itself.
  std::map<std::string, RowDigest> digestsBy(const std::string& column);

 private:
  Hash hashRow();

  std::vector<std::string> names_;      // of the columns, sorted
  std::vector<std::uint64_t> numbers_;  // of the columns, from their names
  Statement rows_;
  std::string bytes_;  // of the present row
};

template <class... Values>
RowDigest digestRows(Database& db, const std::string& table, const std::string& where, const Values&... values) {
  RowDigester digester(db, table, where);
  digester.rows().start(values...);
  return digester.digest();
}

}  // namespace morula

#pragma once
// A digest of the rows of a table. It tells whether the rows are still those that were written.
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/hash.h"
#include "database/database.h"

namespace morula {

/// The number of rows, and the sum modulo 2^128 of each row's hash. The order of rows does not count, so later rows can
/// be added to the digest.
struct RowDigest {
  std::uint64_t rows = 0;
  Hash sum;

  RowDigest& operator+=(const RowDigest& more);
  friend bool operator==(const RowDigest&, const RowDigest&) = default;
};

/// Digests the rows of a table for which `where` holds ("run_id = ?"); `values` are its parameters. The hash of a row
/// is XXH3-128 over the names, types and values of its columns that are not NULL. So a column that joins a table later
/// changes no digest, and a renamed one does. Throws StoreError if the table or a column of `where` is missing.
template <class... Values>
RowDigest digestRows(Database& db, const std::string& table, const std::string& where, const Values&... values);

/// The statement that reads the rows for digestRows, and their digests.
class RowDigester {
 public:
  RowDigester(Database& db, const std::string& table, const std::string& where);
  Statement& rows() { return rows_; }
  /// Returns the digest of all rows of the statement, which must have been started.
  RowDigest digest();
  /// Returns a digest for each value of a column of texts.
  std::map<std::string, RowDigest> digestsBy(const std::string& column);

 private:
  Hash hashRow();

  std::vector<std::string> names_;      // the names of the columns, sorted
  std::vector<std::uint64_t> numbers_;  // the numbers of the columns, hashed from their names
  Statement rows_;
  std::string bytes_;  // bytes of the present row
};

template <class... Values>
RowDigest digestRows(Database& db, const std::string& table, const std::string& where, const Values&... values) {
  RowDigester digester(db, table, where);
  digester.rows().start(values...);
  return digester.digest();
}

}  // namespace morula

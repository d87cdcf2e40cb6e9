#pragma once
// The tables of a file of results: rows, room on the disk and purpose, and their values, to be written elsewhere or
// compared.
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "database/database.h"

namespace morula {

struct TableContents {
  std::string table;
  std::uint64_t rows = 0;
  std::uint64_t bytes = 0;
  // True if `bytes` is estimated from the length of the values, or from the share of the rows that were asked for
  bool estimated = false;
  std::string why;  // the readers of the table, and when it is stored
};

/// A value of SQLite's; the first alternative is NULL. Bytes (BLOB) are a text, too.
using TableValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using TableRow = std::vector<TableValue>;

/// Returns the names of all tables, in the order of their creation.
std::vector<std::string> tableNames(Database& db);
/// A column in the file's table.
struct FileColumn {
  std::string name, type;
  std::int64_t key = 0;  // its place in the table's key, from 1; 0: not in the key
};
/// Returns the columns of a table, in their order; none if there is no such table.
std::vector<FileColumn> fileColumns(Database& db, const std::string& table);
/// Lists the names of columns for SQL.
std::string namesOf(const std::vector<FileColumn>& columns);
/// Returns the value of a column. Throws StoreError if its type is not the column's.
TableValue valueAt(const Statement& row, int place, const std::string& type);

}  // namespace morula

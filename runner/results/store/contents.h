#pragma once
// The tables of a file of results: rows, room on the disk, and the reason why each is there; and their values, to be
// written elsewhere or compared.
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
  // Bytes: by the length of the values, or by the share of the rows that were asked for
  bool estimated = false;
  std::string why;  // who reads it, and when it is stored
};

/// A value as SQLite has it; the first is NULL. Bytes (BLOB) are a text, too.
using TableValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using TableRow = std::vector<TableValue>;

/// In the order in which they were made.
std::vector<std::string> tableNames(Database& db);
/// A column as the file has it.
struct FileColumn {
  std::string name, type;
  std::int64_t key = 0;  // its place in the table's key, from 1; 0: no part of it
};
/// In their order; none if there is no such table.
std::vector<FileColumn> fileColumns(Database& db, const std::string& table);
/// Lists the names of columns for SQL.
std::string namesOf(const std::vector<FileColumn>& columns);
/// Throws StoreError for a value of another type than the column's.
TableValue valueAt(const Statement& row, int place, const std::string& type);

}  // namespace morula

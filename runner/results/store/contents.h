#pragma once
// What a file of results consists of: per table its rows, its room on the disk, and why it is there;
// and the tables as they stand, to be written down elsewhere.
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace morula {

class Database;
struct SqlTable;

struct TableContents {
  std::string table;
  std::uint64_t rows = 0;
  std::uint64_t bytes = 0;
  // Bytes: by the length of the values, or by the share of the rows that were asked for
  bool estimated = false;
  std::string why;  // who reads it, and when it is stored
};

/// All tables, in the order of the schema; why is said of those in `known`. `id`: rows of this run alone; "": of all runs. Throws
/// StoreError.
std::vector<TableContents> contentsOf(Database& db, const std::string& id, const std::vector<const SqlTable*>& known);

class Database;

/// A value as SQLite has it; the first is NULL.
using TableValue = std::variant<std::monostate, std::int64_t, double, std::string>;
using TableRow = std::vector<TableValue>;

/// The columns of a table, apart from bytes (BLOB); none if there is no such table.
std::vector<std::string> plainColumns(Database& db, const std::string& table);

/// Calls `take` for each row, with the values of plainColumns, in the order of the table's key. `run`: rows with this run_id
/// alone, if the table has that column; "": all. Throws StoreError for values of another type than the column's.
void eachRow(Database& db, const std::string& table, const std::string& run,
             const std::function<void(const TableRow&)>& take);

}  // namespace morula

#pragma once
// The tables as they stand, to be written down elsewhere.
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace morula {

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

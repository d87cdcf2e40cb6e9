#pragma once
// What a file of results consists of: per table its rows, its room on the disk, and why it is there.
#include <cstdint>
#include <string>
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

}  // namespace morula

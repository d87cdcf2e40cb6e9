#pragma once
// Tables as comma-separated values, by RFC 4180: UTF-8, lines that end in CR LF, a header line, quotes where needed. A
// missing value (NULL, NaN) is an empty field; an empty text is "". The egg's empty path is written as `egg`, for
// programs that take "" for a missing value. Numbers are the shortest that read back the same. A database's tables, for
// spreadsheets and statistics, are one file each: runs, cells, samples, …
#include <string>
#include <vector>

#include "store/contents.h"
#include "store/store.h"

namespace morula {

/// Returns a cell's path for other programs: "egg" instead of the empty path.
std::string csvPath(const std::string& path);

class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& columns) { add({columns.begin(), columns.end()}); }
  void add(const TableRow& row);
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

struct NamedTable {
  std::string name;  // "cells"
  std::string text;
};

/// Returns all names that csvTables knows, in their order.
std::vector<std::string> csvTableNames();

/// Returns the tables, with run_id in front where rows belong to a run. `id`: only this run; "": all runs. `only`: only
/// this table; "": all tables of the database. Measures on demand are a table each for world, cell and pair, with a
/// column for each measure. A study's database also gives conditions, replicates, tasks and results.
std::vector<NamedTable> csvTables(Store& store, const std::string& id, const std::string& only = "");

}  // namespace morula

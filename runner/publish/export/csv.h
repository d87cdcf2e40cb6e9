#pragma once
// Tables as comma-separated values, by RFC 4180: UTF-8, lines that end in CR LF, a header line, quotes where needed. A
// missing value (NULL, NaN) is an empty field; an empty text is "". The egg's empty path is written as `egg`, for
// programs that take "" for a missing value. Numbers are the shortest that read back the same. A database's tables, for
// spreadsheets and statistics, are one file each: runs, cells, samples, … Meanings and units of columns are JSON beside
// the tables, so that a table has one line of headers and no comments.
#include <string>
#include <vector>

#include "store/contents.h"
#include "store/store.h"
#include "system/json.h"
#include "values/units.h"

namespace morula {

/// Returns a cell's path for other programs: "egg" instead of the empty path.
std::string csvPath(const std::string& path);

struct CsvColumn {
  std::string name;
  std::string meaning = {};  // "": the name says it
  std::string unit = {};     // "length³"; "": a pure number, or none
};

class CsvTable {
 public:
  explicit CsvTable(std::vector<CsvColumn> columns);
  void add(const TableRow& row);
  const std::string& text() const { return text_; }
  /// Returns {"born": {"meaning": "…", "unit": "time", "known_unit": {"name": "min", "factor": 4}}, …}. A column has a
  /// known unit if `units` give one: its numbers, times the factor, are in it.
  Json columns(const Units& units = {}) const;

 private:
  std::vector<CsvColumn> columns_;
  std::string text_;
};

struct NamedTable {
  std::string name;  // "cells"
  CsvTable table;
};

/// Returns all names that csvTables knows, in their order.
std::vector<std::string> csvTableNames();

/// Returns the tables, with run_id in front where rows belong to a run. `id`: only this run; "": all runs. `only`: only
/// this table; "": all tables of the database. Measures on demand are a table each for world, cell and pair, with a
/// column for each measure. A study's database also gives conditions, replicates, tasks and results.
std::vector<NamedTable> csvTables(Store& store, const std::string& id, const std::string& only = "");

}  // namespace morula

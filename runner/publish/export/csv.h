#pragma once
// Tables as comma-separated values, by RFC 4180: UTF-8, lines end in CR LF, a header line, quotes where a text needs
// them. A missing value (NULL, not a number) is an empty field; an empty text is "". A cell's path is `egg` where it is
// empty, so that programs that do not tell "" from an empty field read the egg, and not a missing value. Numbers are
// the shortest that read back as the same. And the tables of a database for spreadsheets and statistics: runs, cells,
// samples, …, each as one file.
#include <string>
#include <vector>

#include "store/contents.h"
#include "store/store.h"

namespace morula {

/// A cell's path as tables for other programs have it: "egg" in place of the empty one.
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

/// All names that csvTables knows, in their order.
std::vector<std::string> csvTableNames();

/// The tables, each with run_id in front where rows are of a run; of the run `id` alone, or with "" of all. `only`:
/// this one; "": all that the database has. Measures on demand are a table for each of world, cell and pair, with a
/// column for each measure; a study's conditions, replicates, tasks and results are there where the database is of a
/// study.
std::vector<NamedTable> csvTables(Store& store, const std::string& id, const std::string& only = "");

}  // namespace morula

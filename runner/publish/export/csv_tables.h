#pragma once
// The tables of a database for spreadsheets and statistics: runs, cells, samples, …, each as one CSV file.
#include <string>
#include <vector>

#include "store/store.h"

namespace morula {

struct NamedTable {
  std::string name;  // "cells"
  std::string text;
};

/// All names that csvTables knows, in their order.
std::vector<std::string> csvTableNames();

/// The tables, each with run_id in front where rows are of a run; of the run `id` alone, or with "" of all. `only`: this one;
/// "": all that the database has. Measures on demand are a table for each of world, cell and pair, with a column for each measure;
/// a study's conditions, replicates, tasks and results are there where the database is of a study.
std::vector<NamedTable> csvTables(Store& store, const std::string& id, const std::string& only = "");

}  // namespace morula

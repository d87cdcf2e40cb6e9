#pragma once
// Two stored runs, table by table: which rows differ, and in what.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morula {

class Database;

/// One value that is not what it should be. Numbers are written so that they read back with the same bits.
struct ValueDifference {
  std::string table;
  std::string row;     // its key: "time 0.25, path AB"
  std::string column;  // "" where one of the two has no such row
  std::string stored, recomputed;
};

struct TableDifference {
  std::string table;
  std::uint64_t rows = 0, recomputedRows = 0;
  std::uint64_t differing = 0;           // rows that differ or that only one of the two has
  std::optional<ValueDifference> first;  // in the order of the table's key
};

/// Compares all tables that results are made of, in the order of the schema, by their keys; of `run` what the
/// computation decides. Equal means: the same bits as far as SQLite keeps them (−0.0 is kept as 0.0, what is
/// no number as NULL). Left out: `checkpoint`, which a finished run does not have, `bullet_sample`, and of
/// `check_result` the kinds golden and bullet, which depend on what is not stored. Throws StoreError.
std::vector<TableDifference> compareTables(Database& stored, const std::string& id, Database& again,
                                           const std::string& idAgain);

}  // namespace morula

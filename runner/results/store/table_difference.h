#pragma once
// Two stored runs, table by table: which rows differ, and in what.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace morula {

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
  std::vector<std::string> missing{};    // columns that the stored table lacks, of measures that it is older than
};

}  // namespace morula
